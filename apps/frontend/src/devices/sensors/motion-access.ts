import { platformOf } from '../../connection/platform.ts';

/** What stands between a page and the motion sensors of its device. */
export type MotionAccess =
  /** The page came over plain HTTP: browsers give no sensors to it. */
  | 'insecure'
  /** The browser has no such events. */
  | 'unsupported'
  /** The browser asks the person, and wants a tap first (iOS). */
  | 'ask'
  /** The person, or an earlier answer, said no. */
  | 'refused'
  | 'granted';

/** iOS has this on the constructors of the events, and no declaration knows it. */
type Ask = (() => Promise<PermissionState>) | undefined;

/** What a window tells of motion, in all browsers. */
export interface MotionWindow {
  readonly isSecureContext: boolean;
  readonly navigator: {
    readonly userAgent: string;
    readonly maxTouchPoints: number;
    /** Chromium has it, and no declaration knows it. */
    readonly userAgentData?: unknown;
  };
  /** Constructors of the events; undefined where there are none. */
  readonly DeviceMotionEvent?: object | undefined;
  readonly DeviceOrientationEvent?: object | undefined;
}

/** As far as it is known without asking. */
export function motionAccessOf(page: MotionWindow): MotionAccess {
  if (!page.isSecureContext) return 'insecure';
  const { DeviceMotionEvent: motion, DeviceOrientationEvent: orientation } = page;
  if (motion === undefined && orientation === undefined) return 'unsupported';
  const hasQuestion = questionOf(motion) !== undefined || questionOf(orientation) !== undefined;
  return hasQuestion && asksPerson(page) ? 'ask' : 'granted';
}

/** Chromium has the question as well, and answers it by itself. An iPad calls itself a Mac. */
function asksPerson({ navigator }: MotionWindow): boolean {
  const { userAgent, maxTouchPoints, userAgentData } = navigator;
  return platformOf(userAgent, maxTouchPoints) === 'ios' || userAgentData === undefined;
}

/** Asks for both kinds of events. To be called at once in the handler of a tap, before any waiting. */
export async function askForMotion(page: MotionWindow): Promise<MotionAccess> {
  const access = motionAccessOf(page);
  if (access !== 'ask') return access;
  try {
    // One question for both; a second call in the same tap is answered without one.
    const answers = await Promise.all([
      questionOf(page.DeviceMotionEvent)?.(),
      questionOf(page.DeviceOrientationEvent)?.(),
    ]);
    return answers.includes('denied') ? 'refused' : 'granted';
  } catch {
    // There was no tap: the next one may ask again.
    return 'ask';
  }
}

/** What asks the person; it may be called from a tap only. */
function questionOf(event: object | undefined): Ask {
  const ask = (event as { requestPermission?: Ask } | undefined)?.requestPermission;
  return ask && (() => ask.call(event));
}
