import { allowCameraWay } from './allow-camera.ts';

/** Reason why there is no picture, and the solution, one sentence each. */
export interface CameraProblem {
  readonly kind: 'insecure' | 'unsupported' | 'refused' | 'missing' | 'in-use' | 'ended' | 'failed';
  readonly text: string;
  readonly wayOut: string;
  /** Whether trying again on this page can help. */
  readonly canRetry: boolean;
}

const INSECURE: CameraProblem = {
  kind: 'insecure',
  text: 'This page uses plain HTTP. Browsers allow cameras over HTTPS only.',
  wayOut: 'Open the same page over HTTPS.',
  canRetry: false,
};

const UNSUPPORTED: CameraProblem = {
  kind: 'unsupported',
  text: 'This browser does not let pages use cameras.',
  wayOut: 'Open the page in Safari, Chrome, Edge or Firefox rather than inside another app.',
  canRetry: false,
};

/** The camera was disconnected while it was in use. */
export const CAMERA_ENDED: CameraProblem = {
  kind: 'ended',
  text: 'The camera stopped: it was unplugged, or its permission was revoked.',
  wayOut: 'Plug the camera in or allow it, then start it again.',
  canRetry: true,
};

/** Returns a problem that is known before the user is asked. */
export function firstCameraProblem(page: {
  readonly isSecureContext: boolean;
  readonly hasMediaDevices: boolean;
}): CameraProblem | undefined {
  if (!page.isSecureContext) return INSECURE;
  return page.hasMediaDevices ? undefined : UNSUPPORTED;
}

/** Returns the problem for the name of the error that the browser reported. */
export function cameraProblemOf(errorName: string, userAgent = navigator.userAgent): CameraProblem {
  switch (errorName) {
    case 'NotAllowedError':
    case 'SecurityError':
      return {
        kind: 'refused',
        text: 'Camera access was denied.',
        wayOut: `${allowCameraWay(userAgent)} Then start the camera again.`,
        canRetry: true,
      };
    case 'NotFoundError':
    case 'OverconstrainedError':
      return {
        kind: 'missing',
        text: 'This device has no camera.',
        wayOut: 'Plug one in and start again, or open this page on a phone.',
        canRetry: true,
      };
    case 'NotReadableError':
    case 'AbortError':
    case 'TrackStartError':
      return {
        kind: 'in-use',
        text: 'The camera is in use by another program or tab.',
        wayOut: 'Close that program or tab, then start the camera again.',
        canRetry: true,
      };
    default:
      return {
        kind: 'failed',
        text: `The browser could not open the camera (${errorName}).`,
        wayOut: 'Choose another camera, or start it again.',
        canRetry: true,
      };
  }
}
