import type { Clip } from './clip.ts';

export type ClipName = 'photos' | 'markers' | 'hand';

/** Clips of the product. A module that finds nothing in one clip may find something in another. */
export const CLIPS: Readonly<
  Record<ClipName, { readonly text: string; readonly load: () => Promise<Clip> }>
> = {
  photos: {
    text: 'Photographs',
    load: async () => (await import('./photo-clip.ts')).loadPhotoClip(),
  },
  hand: {
    text: 'Drawn hand',
    load: async () => (await import('./hand-clip.ts')).loadHandClip(),
  },
  markers: {
    text: 'Printed markers',
    load: async () => ({ draw: (await import('./marker-clip.ts')).drawMarkerClip }),
  },
};
