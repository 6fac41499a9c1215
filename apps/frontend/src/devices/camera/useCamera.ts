import { useEventListener } from '@vueuse/core';
import { onScopeDispose, shallowRef, watch } from 'vue';
import {
  CAMERA_ENDED,
  cameraProblemOf,
  firstCameraProblem,
  type CameraProblem,
} from './camera-problem.ts';

/** `paused`: the page is hidden or not connected, and the camera comes back with it. */
export type CameraStatus = 'off' | 'asking' | 'on' | 'paused';

/** Browsers that have a light tell so; no declaration knows it. */
type TorchCapabilities = MediaTrackCapabilities & { readonly torch?: boolean };

/** A connection that was lost this long ago receives nothing: the camera is let go, milliseconds. */
const UNNEEDED_MS = 3000;

/** What is asked of a camera: enough for the largest picture that is published. */
const WANTED = { width: { ideal: 640 }, height: { ideal: 480 }, frameRate: { ideal: 30 } };

/**
 * The camera of this device, while the calling scope lives, the camera is needed, and the page is visible.
 *
 * @param first id of the one to be opened; when it is gone, any other is
 * @param isNeeded false while nothing can be sent: the camera pauses soon, and its light goes out
 */
export function useCamera(first = '', isNeeded: () => boolean = () => true) {
  const status = shallowRef<CameraStatus>('off');
  const problem = shallowRef<CameraProblem | undefined>(firstProblem());
  const stream = shallowRef<MediaStream>();
  const cameras = shallowRef<readonly { readonly id: string; readonly name: string }[]>([]);
  /** Empty: the browser's choice, on phones the one at the back. */
  const chosen = shallowRef(first);
  const torch = shallowRef<'missing' | 'off' | 'on'>('missing');
  let attempt = 0;

  async function start(id = chosen.value): Promise<void> {
    const mine = ++attempt;
    end();
    problem.value = firstProblem();
    if (problem.value) return;
    status.value = 'asking';
    try {
      const opened = await navigator.mediaDevices.getUserMedia({ video: constraintsFor(id) });
      // Stopped, hidden or left meanwhile.
      if (mine !== attempt) return endTracks(opened);
      // Hidden while the user was asked: it comes back with the page.
      if (document.visibilityState === 'hidden') {
        endTracks(opened);
        status.value = 'paused';
        return;
      }
      take(opened);
    } catch (error) {
      if (mine !== attempt) return;
      // A camera that was chosen may be gone; any other is better than none.
      if (id !== '' && isGone(error as DOMException)) return start('');
      problem.value = cameraProblemOf((error as DOMException).name);
      status.value = 'off';
    }
  }

  function take(opened: MediaStream): void {
    const [track] = opened.getVideoTracks();
    if (!track) return;
    track.addEventListener('ended', () => {
      if (stream.value !== opened) return;
      stop();
      problem.value = CAMERA_ENDED;
    });
    chosen.value = track.getSettings().deviceId ?? '';
    const { torch: hasTorch } = (track.getCapabilities?.() ?? {}) as TorchCapabilities;
    torch.value = hasTorch ? 'off' : 'missing';
    stream.value = opened;
    status.value = 'on';
    void list();
  }

  /** Names are told once a camera is allowed. */
  async function list(): Promise<void> {
    const devices = await navigator.mediaDevices.enumerateDevices();
    cameras.value = devices
      .filter(({ kind }) => kind === 'videoinput')
      .map(({ deviceId, label }, index) => ({
        id: deviceId,
        name: label || `Camera ${index + 1}`,
      }));
  }

  function end(): void {
    if (stream.value) endTracks(stream.value);
    stream.value = undefined;
    torch.value = 'missing';
  }

  function stop(): void {
    attempt += 1;
    end();
    status.value = 'off';
  }

  async function setTorch(isOn: boolean): Promise<void> {
    const [track] = stream.value?.getVideoTracks() ?? [];
    const advanced = [{ torch: isOn }] as unknown as MediaTrackConstraintSet[];
    try {
      await track?.applyConstraints({ advanced });
      torch.value = isOn ? 'on' : 'off';
    } catch {
      // Some cameras say that they have a light, and have none.
      torch.value = 'missing';
    }
  }

  function pause(): void {
    if (status.value !== 'on') return;
    stop();
    status.value = 'paused';
  }
  function resume(): void {
    if (status.value === 'paused' && document.visibilityState === 'visible' && isNeeded()) {
      void start();
    }
  }
  // The camera stops while the page is hidden.
  useEventListener(document, 'visibilitychange', () => {
    if (document.visibilityState === 'hidden') pause();
    else resume();
  });
  watch(isNeeded, (needed, _before, onCleanup) => {
    if (needed) return resume();
    const timer = setTimeout(pause, UNNEEDED_MS);
    onCleanup(() => clearTimeout(timer));
  });
  if (problem.value === undefined) {
    useEventListener(navigator.mediaDevices, 'devicechange', () => {
      if (status.value === 'on') void list();
    });
  }
  onScopeDispose(stop);

  return { status, problem, stream, cameras, chosen, torch, start, stop, setTorch };
}

function firstProblem(): CameraProblem | undefined {
  return firstCameraProblem({ isSecureContext, hasMediaDevices: 'mediaDevices' in navigator });
}

function constraintsFor(id: string): MediaTrackConstraints {
  return id === ''
    ? { ...WANTED, facingMode: { ideal: 'environment' } }
    : { ...WANTED, deviceId: { exact: id } };
}

/** Browsers differ in what they say of a camera that is not there any more. */
function isGone({ name }: DOMException): boolean {
  return name === 'OverconstrainedError' || name === 'NotFoundError';
}

function endTracks(stream: MediaStream): void {
  for (const track of stream.getTracks()) track.stop();
}
