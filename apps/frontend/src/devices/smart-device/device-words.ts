import type { Vector3, Vector4 } from '@ubii/proto';
import { formatNumber } from '../../ui/readouts/format-number.ts';
import type { LocationState } from '../sensors/useLocation.ts';
import type { MicrophoneState } from '../sensors/useMicrophoneLevel.ts';
import type { MotionAccess } from '../sensors/motion-access.ts';

const INSECURE = 'Needs HTTPS: this page uses plain HTTP';

/** Formats numbers in a fixed width, so that the layout is stable. */
export function vectorText({ x, y, z }: Vector3, decimals = 2, width = 5): string {
  return [x, y, z].map((value) => formatNumber(value, decimals).padStart(width)).join(' ');
}

export function anglesText({ x, y, z }: Vector3): string {
  const [yaw, pitch, roll] = [x, y, z].map((value) => formatNumber(value).padStart(4));
  return `yaw${yaw} pitch${pitch} roll${roll}`;
}

export function locationText({ x, y, w }: Vector4): string {
  return `${formatNumber(x, 5)} ${formatNumber(y, 5)} ±${formatNumber(w)} m`;
}

/** Returns why no motion events arrive, and the solution. */
export function motionWords(access: MotionAccess, isSilent: boolean): string {
  switch (access) {
    case 'insecure':
      return INSECURE;
    case 'unsupported':
      return 'This browser has no motion sensors';
    case 'ask':
      return 'Off until you allow it';
    case 'refused':
      return 'Denied. Restart the browser to be asked again';
    case 'granted':
      return isSilent ? 'This device sends no motion data' : 'Waiting for the first value';
  }
}

export function microphoneWords(state: MicrophoneState): string {
  switch (state) {
    case 'insecure':
      return INSECURE;
    case 'missing':
      return 'This device has no microphone';
    case 'refused':
      return 'Denied. Allow it in the browser’s settings for this page';
    case 'asking':
      return 'Tap Allow in the browser’s prompt';
    case 'on':
      return 'Listening';
    case 'off':
      return 'Off until you allow it. Only the level leaves this device';
  }
}

export function locationWords(state: LocationState): string {
  switch (state) {
    case 'insecure':
      return INSECURE;
    case 'missing':
      return 'Location is not available';
    case 'refused':
      return 'Denied. Allow it in the browser’s settings for this page';
    case 'asking':
      return 'Tap Allow; the first position takes a moment';
    case 'on':
      return 'Waiting for the first position';
    case 'off':
      return 'Off until you allow it';
  }
}
