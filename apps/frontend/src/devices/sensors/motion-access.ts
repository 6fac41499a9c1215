import { platformOf } from '../../connection/platform.ts';

/** Availability of motion sensors to a page. */
export type MotionAccess =
  /** The page was loaded over plain HTTP, where browsers provide no sensors. */
  | 'insecure'
  /** The browser does not support the events. */
  | 'unsupported'
  /** The browser must ask the user, which requires a tap (iOS). */
  | 'ask'
  /** The user refused, now or earlier. */
  | 'refused'
  | 'granted';

/** iOS has this on the event constructors; TypeScript's DOM types lack it. */
type Ask = (() => Promise<PermissionState>) | undefined;

/** Properties of a window related to motion, in all browsers. */
export interface MotionWindow {
  readonly isSecureContext: boolean;
  readonly navigator: {
    readonly userAgent: string;
    readonly maxTouchPoints: number;
    /** Chromium only; TypeScript's DOM types lack it. */
    readonly userAgentData?: unknown;
  };
  /** Event constructors; undefined where not supported. */
  readonly DeviceMotionEvent?: object | undefined;
  readonly DeviceOrientationEvent?: object | undefined;
}

/** Returns the availability as known without asking. */
export function motionAccessOf(page: MotionWindow): MotionAccess {
  if (!page.isSecureContext) return 'insecure';
  const { DeviceMotionEvent: motion, DeviceOrientationEvent: orientation } = page;
  if (motion === undefined && orientation === undefined) return 'unsupported';
  const hasQuestion = questionOf(motion) !== undefined || questionOf(orientation) !== undefined;
  return hasQuestion && asksPerson(page) ? 'ask' : 'granted';
}

/**
 * Whether the browser asks the user. Chromium has the method as well, and answers by itself. An iPad identifies itself
 * as a Mac.
 */
function asksPerson({ navigator }: MotionWindow): boolean {
  const { userAgent, maxTouchPoints, userAgentData } = navigator;
  return platformOf(userAgent, maxTouchPoints) === 'ios' || userAgentData === undefined;
}

/** Requests both kinds of events. Call it synchronously in the handler of a tap. */
export async function askForMotion(page: MotionWindow): Promise<MotionAccess> {
  const access = motionAccessOf(page);
  if (access !== 'ask') return access;
  try {
    // The browser shows one prompt for both; the second call in the same tap is answered without one.
    const answers = await Promise.all([
      questionOf(page.DeviceMotionEvent)?.(),
      questionOf(page.DeviceOrientationEvent)?.(),
    ]);
    return answers.includes('denied') ? 'refused' : 'granted';
  } catch {
    // Without a user interaction; the next tap may ask again.
    return 'ask';
  }
}

/** The method that asks the user; requires a user interaction. */
function questionOf(event: object | undefined): Ask {
  const ask = (event as { requestPermission?: Ask } | undefined)?.requestPermission;
  return ask && (() => ask.call(event));
}
