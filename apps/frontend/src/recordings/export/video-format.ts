/** Container of a video. */
export type VideoKind = 'webm' | 'mp4';

interface Size {
  readonly width: number;
  readonly height: number;
}

/** Codecs in the order in which they are tried, of the lowest level that every encoder has. */
const CODECS: readonly { readonly codec: string; readonly kind: VideoKind }[] = [
  { codec: 'vp09.00.10.08', kind: 'webm' },
  { codec: 'vp8', kind: 'webm' },
  { codec: 'avc1.42001f', kind: 'mp4' },
];
const USUAL: Size = { width: 640, height: 480 };

/** The container of what this browser encodes. @throws when it encodes nothing that is known */
export async function videoKind(): Promise<VideoKind> {
  for (const { codec, kind } of CODECS) {
    const { supported } = await VideoEncoder.isConfigSupported({ codec, ...USUAL });
    if (supported === true) return kind;
  }
  throw new Error(
    'This browser encodes neither VP9, VP8 nor H.264. Choose another format or browser.',
  );
}

/** Larger pictures are scaled down, pixels. */
const MAX_SIDE = 1920;

/** The size of a video of pictures. Encoders take even sides only. */
export function evenSize({ width, height }: Size): Size {
  const scale = Math.min(1, MAX_SIDE / Math.max(width, height));
  const even = (side: number): number => Math.max(2, 2 * Math.round((side * scale) / 2));
  return { width: even(width), height: even(height) };
}
