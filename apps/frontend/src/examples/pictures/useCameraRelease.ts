import { watch, type Ref } from 'vue';
import type { PictureSources } from './usePictureSource.ts';

/** Releases the camera when sending stops, so that its indicator turns off; Start opens it again. */
export function useCameraRelease({ kind, camera }: PictureSources, isOn: Ref<boolean>): void {
  watch(isOn, (on) => {
    if (kind.value !== 'camera') return;
    if (!on) camera.stop();
    else if (camera.status.value === 'off') void camera.start();
  });
}
