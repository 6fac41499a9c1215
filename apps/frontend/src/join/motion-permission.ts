import { thisPlatform } from './platform.ts';

/** What stands between a page and the motion sensors. */
export type MotionAccess =
  /** The page is not secure. */
  | 'insecure'
  /** The browser has no such interface. */
  | 'missing'
  /** iOS: has to be asked for from within a tap. */
  | 'asks'
  /** Nothing, when the device has sensors. */
  | 'open';

type AskingEvent = { requestPermission?: () => Promise<'granted' | 'denied'> };

export function motionAccess(): MotionAccess {
  if (!isSecureContext) return 'insecure';
  if (typeof DeviceMotionEvent === 'undefined') return 'missing';
  // Other browsers have the question, too, and answer it by themselves
  const hasQuestion = (DeviceMotionEvent as AskingEvent).requestPermission !== undefined;
  return hasQuestion && thisPlatform() === 'ios' ? 'asks' : 'open';
}

/**
 * Asks the person; only from within a tap. Who said no is not asked again by iOS until the browser is
 * started anew.
 * @returns false when it was denied
 */
export async function allowMotion(): Promise<boolean> {
  // Asked for in one turn: the second question would be outside the tap
  const asked = [DeviceMotionEvent, globalThis.DeviceOrientationEvent].map(
    (event) =>
      (event as AskingEvent | undefined)?.requestPermission?.() ??
      Promise.resolve('granted' as const),
  );
  try {
    return (await Promise.all(asked)).every((answer) => answer === 'granted');
  } catch {
    return false;
  }
}

/** Whether motion values arrive within `waitMs`. */
export function motionArrives(waitMs: number): Promise<boolean> {
  return new Promise((resolve) => {
    const finish = (arrives: boolean): void => {
      removeEventListener('devicemotion', handle);
      removeEventListener('deviceorientation', handle);
      clearTimeout(timer);
      resolve(arrives);
    };
    const handle = (event: DeviceMotionEvent | DeviceOrientationEvent): void => {
      const value =
        event instanceof DeviceOrientationEvent ? event.beta : event.rotationRate?.alpha;
      // A device without sensors sends one event without values
      if (value !== null && value !== undefined) finish(true);
    };
    const timer = setTimeout(() => finish(false), waitMs);
    addEventListener('devicemotion', handle);
    addEventListener('deviceorientation', handle);
  });
}
