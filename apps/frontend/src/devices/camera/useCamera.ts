import { useEventListener } from '@vueuse/core';
import { onScopeDispose, shallowRef, watch } from 'vue';
import {
  CAMERA_ENDED,
  cameraProblemOf,
  firstCameraProblem,
  type CameraProblem,
} from './camera-problem.ts';

/** `paused`: the page is hidden or disconnected; the camera resumes with it. */
export type CameraStatus = 'off' | 'asking' | 'on' | 'paused';

/** Browsers report a torch, but TypeScript's DOM types lack it. */
type TorchCapabilities = MediaTrackCapabilities & { readonly torch?: boolean };

/** Time without a connection after which the camera is released, milliseconds. */
const UNNEEDED_MS = 3000;

/** Constraints for the camera: the largest picture that is published. */
const WANTED = { width: { ideal: 640 }, height: { ideal: 480 }, frameRate: { ideal: 30 } };

/**
 * The camera of this device, while the calling scope is active, the camera is needed, and the page is visible.
 *
 * @param first id of the camera to open; if it is not available, any other
 * @param isNeeded false while nothing can be sent: the camera is released after `UNNEEDED_MS`
 */
export function useCamera(first = '', isNeeded: () => boolean = () => true) {
  const status = shallowRef<CameraStatus>('off');
  const problem = shallowRef<CameraProblem | undefined>(firstProblem());
  const stream = shallowRef<MediaStream>();
  const cameras = shallowRef<readonly { readonly id: string; readonly name: string }[]>([]);
  /** Id of the chosen camera; empty: the browser's choice, on phones the rear camera. */
  const chosen = shallowRef(first);
  const torch = shallowRef<'missing' | 'off' | 'on'>('missing');
  let openings = 0;

  async function start(id = chosen.value): Promise<void> {
    const mine = ++openings;
    end();
    problem.value = firstProblem();
    if (problem.value) return;
    status.value = 'asking';
    try {
      const opened = await navigator.mediaDevices.getUserMedia({ video: constraintsFor(id) });
      // Stopped, hidden or unmounted in the meantime.
      if (mine !== openings) return endTracks(opened);
      // The page was hidden during the permission prompt: resume when it is visible.
      if (document.visibilityState === 'hidden') {
        endTracks(opened);
        status.value = 'paused';
        return;
      }
      take(opened);
    } catch (error) {
      if (mine !== openings) return;
      // The chosen camera may be unavailable; use any other.
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

  /** Lists cameras; their labels are available once a camera is allowed. */
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
    openings += 1;
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
      // Some cameras report a torch that they do not have.
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
  // Pauses the camera while the page is hidden.
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

/** Whether an error means a missing camera, for which browsers use different names. */
function isGone({ name }: DOMException): boolean {
  return name === 'OverconstrainedError' || name === 'NotFoundError';
}

function endTracks(stream: MediaStream): void {
  for (const track of stream.getTracks()) track.stop();
}
