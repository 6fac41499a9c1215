import type { Object2DList } from '@ubii/proto';
import { onScopeDispose, shallowRef, watch } from 'vue';
import { useDevice } from '../useDevice.ts';
import { CAMERA_COMPONENTS, CAMERA_DEVICE } from './components.ts';
import { videoSource, type PictureSettings } from './encode-picture.ts';
import { RateMeter } from '../sensors/rate-meter.ts';
import type { PictureHabits } from './picture-habits.ts';
import { useFrameTimes } from './useFrameTimes.ts';
import { usePictures } from './usePictures.ts';

/** Time without an update after which boxes are outdated, milliseconds. */
const OBJECTS_HOLD_MS = 5000;

/** Camera device: publishes pictures, receives the objects detected in them. */
export function useCameraDevice(options: {
  readonly video: () => HTMLVideoElement | null;
  /** True while the camera is on and has a receiver. */
  readonly isWanted: () => boolean;
  readonly settings: Readonly<PictureSettings>;
  readonly habits: () => Readonly<PictureHabits>;
  /** JSON text; empty without a calibration. */
  readonly calibration: () => string;
}) {
  const objects = shallowRef<Object2DList>();
  /** Time from the newest sent picture to the next boxes, milliseconds. */
  const answerMs = shallowRef<number>();
  const results = new RateMeter(OBJECTS_HOLD_MS);
  const frames = useFrameTimes(options.video);
  let holdTimer: ReturnType<typeof setTimeout> | undefined;

  const device = useDevice({
    name: CAMERA_DEVICE,
    tags: ['camera', 'web interface'],
    components: CAMERA_COMPONENTS,
    receivers: {
      objects(found) {
        objects.value = found;
        results.note(performance.now());
        const { sentAtMs } = measures;
        if (sentAtMs !== undefined) answerMs.value = performance.now() - sentAtMs;
        clearTimeout(holdTimer);
        holdTimer = setTimeout(() => {
          objects.value = undefined;
          answerMs.value = undefined;
        }, OBJECTS_HOLD_MS);
      },
    },
  });
  const measures = usePictures({
    source: () => videoSource(options.video(), frames.takenMs()),
    isWanted: () => options.isWanted() && device.isRegistered.value,
    settings: options.settings,
    habits: options.habits,
    resultHz: () => results.rateHz(performance.now()),
    publish: (image, { ageMs, expiryMs }) =>
      device.publishTaken('camera_image', image, ageMs, { immediate: true, expiryMs }),
    end: () => device.end('camera_image'),
  });
  watch(
    [options.calibration, device.isRegistered],
    ([json, isKnown]) => isKnown && device.publish('calibration', json),
    { immediate: true },
  );
  onScopeDispose(() => clearTimeout(holdTimer));

  return {
    objects,
    answerMs,
    measures,
    isRegistered: device.isRegistered,
    topicOf: device.topicOf,
  };
}
