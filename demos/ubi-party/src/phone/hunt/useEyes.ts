import { inject, onScopeDispose, shallowRef, type InjectionKey, type ShallowRef } from 'vue';
import type { Detector, OpenDetector } from './detector/detector.ts';

/** Says what to do when the browser opens no camera, by the name of its error. */
export type CameraHelp = (errorName: string) => string;

export type CameraState =
  | { readonly status: 'off' | 'opening' }
  | { readonly status: 'on'; readonly stream: MediaStream; readonly hasTorch: boolean }
  | { readonly status: 'missing'; readonly help: string };

export type DetectorState =
  | { readonly status: 'loading'; readonly loadedBytes: number }
  | { readonly status: 'ready'; readonly detector: Detector }
  | { readonly status: 'failed'; readonly reason: string };

/** Camera and detector of a hunt, from its explanation to its end. */
export interface Eyes {
  readonly camera: Readonly<ShallowRef<CameraState>>;
  readonly detector: Readonly<ShallowRef<DetectorState>>;
  /** Asks for the camera; the browser may ask the user. */
  openCamera(): Promise<void>;
  /** The other side of the phone. */
  turnCamera(): Promise<void>;
  setTorch(isOn: boolean): Promise<void>;
  /** Loads the detector again after it has failed. */
  loadDetector(): Promise<void>;
}

export const EYES: InjectionKey<Eyes> = Symbol('eyes');

export function useEyes(): Eyes {
  const eyes = inject(EYES);
  if (!eyes) throw new Error('Screens of a hunt live inside HuntScreens.');
  return eyes;
}

/** Opens both for as long as the calling scope lives. The camera opens by itself where it is allowed already. */
export function createEyes(open: OpenDetector, help: CameraHelp): Eyes {
  const camera = shallowRef<CameraState>({ status: 'off' });
  const detector = shallowRef<DetectorState>({ status: 'loading', loadedBytes: 0 });
  let facingMode: 'environment' | 'user' = 'environment';
  let isGone = false;

  function closeCamera(): void {
    if (camera.value.status === 'on')
      for (const track of camera.value.stream.getTracks()) track.stop();
    camera.value = { status: 'off' };
  }

  async function openCamera(): Promise<void> {
    if (camera.value.status === 'opening') return;
    closeCamera();
    camera.value = { status: 'opening' };
    try {
      if (!('mediaDevices' in navigator)) throw new DOMException('', 'NotSupportedError');
      const video = { facingMode, width: { ideal: 1280 }, height: { ideal: 960 } };
      const stream = await navigator.mediaDevices.getUserMedia({ video, audio: false });
      if (isGone) return stream.getTracks().forEach((track) => track.stop());
      const [track] = stream.getVideoTracks();
      track?.addEventListener('ended', () => {
        camera.value = { status: 'missing', help: help('ended') };
      });
      const abilities: object = track?.getCapabilities?.() ?? {};
      camera.value = { status: 'on', stream, hasTorch: 'torch' in abilities };
    } catch (cause) {
      camera.value = { status: 'missing', help: help((cause as Error).name) };
    }
  }

  async function loadDetector(): Promise<void> {
    detector.value = { status: 'loading', loadedBytes: 0 };
    try {
      const opened = await open((loadedBytes) => {
        if (detector.value.status === 'loading')
          detector.value = { status: 'loading', loadedBytes };
      });
      if (isGone) opened.close();
      else detector.value = { status: 'ready', detector: opened };
    } catch (cause) {
      detector.value = { status: 'failed', reason: (cause as Error).message };
    }
  }

  onScopeDispose(() => {
    isGone = true;
    closeCamera();
    if (detector.value.status === 'ready') detector.value.detector.close();
  });
  void loadDetector();
  void isCameraAllowed().then(async (isAllowed) => {
    if (isAllowed && !isGone) await openCamera();
  });

  return {
    camera,
    detector,
    openCamera,
    loadDetector,
    async turnCamera() {
      facingMode = facingMode === 'environment' ? 'user' : 'environment';
      await openCamera();
    },
    async setTorch(isOn) {
      if (camera.value.status !== 'on') return;
      const [track] = camera.value.stream.getVideoTracks();
      const torch = { advanced: [{ torch: isOn } as MediaTrackConstraintSet] };
      await track?.applyConstraints(torch).catch(() => undefined);
    },
  };
}

async function isCameraAllowed(): Promise<boolean> {
  try {
    return (await navigator.permissions.query({ name: 'camera' })).state === 'granted';
  } catch {
    return false; // the browser does not report it
  }
}
