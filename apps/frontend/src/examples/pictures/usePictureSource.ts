import { MAX_CHOSEN_PIXELS } from '@ubii/pictures';
import { useEventListener } from '@vueuse/core';
import { computed, shallowRef, watch, type ComputedRef, type ShallowRef } from 'vue';
import type { PictureSource } from '../../devices/camera/encode-picture.ts';
import { useCamera } from '../../devices/camera/useCamera.ts';
import { useFrameTimes } from '../../devices/camera/useFrameTimes.ts';
import { pictureBitmap } from '../../formats/picture-bitmap.ts';
import { RateMeter } from '../../devices/sensors/rate-meter.ts';
import type { ClipName } from './clips/clips.ts';
import { useClip } from './clips/useClip.ts';
import { useKeptChoice } from './useKeptChoice.ts';

/** Kinds of picture sources. */
export type SourceKind = 'clip' | 'camera' | 'photo' | 'topic';

type PictureElement = HTMLVideoElement | HTMLCanvasElement;

/** Source of pictures: a built-in clip, a camera, an image file, or a topic. */
export interface PictureSources {
  readonly kind: ShallowRef<SourceKind>;
  readonly clip: ShallowRef<ClipName>;
  readonly camera: ReturnType<typeof useCamera>;
  /** Displayed element; `undefined` while there is no picture, and for a topic. */
  readonly element: ComputedRef<PictureElement | undefined>;
  /** Size of the displayed picture, pixels. */
  readonly size: ComputedRef<{ readonly width: number; readonly height: number } | undefined>;
  /** Name of the image file. */
  readonly fileName: Readonly<ShallowRef<string | undefined>>;
  /** Problem of the image file, one sentence. */
  readonly fileProblem: Readonly<ShallowRef<string | undefined>>;
  /** Topic of the pictures; empty until one is chosen. */
  readonly topic: ShallowRef<string>;
  /** True while pictures are sent: the clip then continues in background tabs. */
  readonly isSent: ShallowRef<boolean>;
  takeFile(file: File): Promise<void>;
  /** Returns the current source for the encoder. */
  source(): PictureSource | undefined;
  /** Measured pictures per second of the clip or the camera; `undefined` for other sources. */
  givenHz(): number | undefined;
}

/** Longer side of a photograph to which larger ones are scaled down, pixels. */
const MAX_PHOTO_SIDE = 1280;

/**
 * Sources of a page, while the calling scope is active; initially a built-in clip.
 *
 * @param firstClip the clip until the user selects another one
 */
export function usePictureSource(firstClip: ClipName = 'photos'): PictureSources {
  // Files and topics are not restored.
  const kind = useKeptChoice<SourceKind>('source', 'clip', (kept) => kept === 'camera');
  const topic = shallowRef('');
  const isSent = shallowRef(false);
  const fileName = shallowRef<string>();
  const fileProblem = shallowRef<string>();
  const photo = shallowRef<HTMLCanvasElement>();
  const camera = useCamera();

  const given = new RateMeter();

  const clip = useClip(firstClip, {
    isShown: () => kind.value === 'clip',
    isSent: () => isSent.value,
    onDrawn: () => given.note(performance.now()),
  });

  const video = document.createElement('video');
  Object.assign(video, { autoplay: true, playsInline: true, muted: true });
  const videoSize = shallowRef<{ readonly width: number; readonly height: number }>();
  function measure(): void {
    const { videoWidth: width, videoHeight: height } = video;
    videoSize.value = width > 0 ? { width, height } : undefined;
  }
  useEventListener(video, ['loadedmetadata', 'resize'], measure);
  const frames = useFrameTimes(() => video);
  watch(camera.stream, (stream) => {
    video.srcObject = stream ?? null;
    if (stream) countFrame();
    else videoSize.value = undefined;
  });
  /** Counts frames, where browsers report those of a video. */
  function countFrame(): void {
    video.requestVideoFrameCallback?.(() => {
      given.note(performance.now());
      if (camera.stream.value) countFrame();
    });
  }

  watch(kind, (next) => {
    if (next !== 'camera') camera.stop();
  });

  async function takeFile(file: File): Promise<void> {
    fileProblem.value = undefined;
    try {
      const bytes = new Uint8Array(await file.arrayBuffer());
      const bitmap = await pictureBitmap(bytes, undefined, MAX_CHOSEN_PIXELS);
      const scale = Math.min(1, MAX_PHOTO_SIDE / Math.max(bitmap.width, bitmap.height));
      const canvas = document.createElement('canvas');
      canvas.width = Math.max(1, Math.round(bitmap.width * scale));
      canvas.height = Math.max(1, Math.round(bitmap.height * scale));
      canvas.getContext('2d')!.drawImage(bitmap, 0, 0, canvas.width, canvas.height);
      bitmap.close();
      photo.value = canvas;
      fileName.value = file.name;
      kind.value = 'photo';
    } catch (error) {
      fileProblem.value =
        error instanceof RangeError
          ? `${file.name}: ${error.message}`
          : `${file.name} is not an image that this browser can read. Choose a JPEG, PNG or WebP file.`;
    }
  }

  const isMeasured = computed(() => kind.value === 'clip' || kind.value === 'camera');
  const element = computed((): PictureElement | undefined => {
    if (kind.value === 'clip') return clip.canvas.value;
    if (kind.value === 'camera') return camera.stream.value && video;
    return kind.value === 'photo' ? photo.value : undefined;
  });
  const size = computed(() => {
    const shown = element.value;
    if (shown === video) return videoSize.value;
    return shown && { width: shown.width, height: shown.height };
  });

  return {
    kind,
    clip: clip.name,
    camera,
    element,
    size,
    fileName,
    fileProblem,
    topic,
    isSent,
    takeFile,
    source() {
      const takenMs = element.value === video ? frames.takenMs() : undefined;
      return element.value && size.value && { element: element.value, ...size.value, takenMs };
    },
    givenHz: () => (isMeasured.value ? given.rateHz(performance.now()) : undefined),
  };
}
