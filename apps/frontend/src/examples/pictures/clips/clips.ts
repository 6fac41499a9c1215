import type { Clip } from './clip.ts';

export type ClipName = 'photos' | 'markers' | 'hand';

/** Clips of the product. A module that finds nothing in one clip may find something in another. */
export const CLIPS: Readonly<
  Record<
    ClipName,
    {
      readonly text: string;
      /** What modules find in it. */
      readonly shows: readonly string[];
      readonly load: () => Promise<Clip>;
    }
  >
> = {
  photos: {
    text: 'Photographs',
    shows: ['objects', 'bodies'],
    load: async () => (await import('./photo-clip.ts')).loadPhotoClip(),
  },
  hand: {
    text: 'Drawn hand',
    shows: ['hands'],
    load: async () => (await import('./hand-clip.ts')).loadHandClip(),
  },
  markers: {
    text: 'Printed markers',
    shows: ['markers'],
    load: async () => ({ draw: (await import('./marker-clip.ts')).drawMarkerClip }),
  },
};
