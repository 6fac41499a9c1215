import { thisPlatform } from '../../../connection/platform.ts';
import { motionAccessOf } from '../../../devices/sensors/motion-access.ts';
import { channelCheck, clockCheck, masterCheck, secureCheck, sensorsCheck } from './check-words.ts';
import type { Check } from './check.ts';
import { motionArrives } from './motion-arrives.ts';
import { probeChannel } from './probe-channel.ts';

const TRIES = 3;
const ANSWER_TIMEOUT_MS = 5000;
/** Time to wait for motion events, milliseconds; sensors report many times in it. */
const MOTION_WAIT_MS = 1500;

/** Runs all checks that are possible before joining, and reports each result at once. */
export async function runPreflight(tell: (check: Check) => void): Promise<void> {
  const page = new URL(location.href);
  tell(secureCheck(isSecureContext, page));
  await Promise.all([runSensors(tell), runLink(page, tell)]);
}

async function runLink(page: URL, tell: (check: Check) => void): Promise<void> {
  const tripMs = await measureTrip();
  tell(masterCheck(tripMs, page));
  const probe = tripMs === undefined ? undefined : await probeChannel(page.origin);
  tell(channelCheck(probe, thisPlatform(), page));
  tell(clockCheck(probe));
}

async function runSensors(tell: (check: Check) => void): Promise<void> {
  const access = motionAccessOf(window);
  const isTouch = matchMedia('(pointer: coarse)').matches;
  if (access !== 'granted') return tell(sensorsCheck(access, undefined, isTouch));
  tell(sensorsCheck(access, await motionArrives(MOTION_WAIT_MS), isTouch));
}

/** Shortest of several round trips, milliseconds; `undefined` without a reply. */
async function measureTrip(): Promise<number | undefined> {
  let bestMs: number | undefined;
  for (let i = 0; i < TRIES; i += 1) {
    const sentMs = performance.now();
    try {
      await fetch('/health', { cache: 'no-store', signal: AbortSignal.timeout(ANSWER_TIMEOUT_MS) });
    } catch {
      return bestMs;
    }
    bestMs = Math.min(bestMs ?? Number.POSITIVE_INFINITY, performance.now() - sentMs);
  }
  return bestMs;
}
