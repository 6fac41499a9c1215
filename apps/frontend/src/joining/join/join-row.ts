import type { Check, CheckId } from './preflight/check.ts';

/** What hinders this phone, in one row above Join. */
export interface JoinRow {
  /** `err`: joining is not possible now. */
  readonly tone: 'warn' | 'err';
  readonly title: string;
  /** What still works, and what to do. */
  readonly text: string;
  /** The one button: a link, or to be asked for motion again. @default the details */
  readonly remedy?: NonNullable<Check['remedy']> | 'ask-again';
}

/** What the row depends on. */
export interface JoinRowFacts {
  readonly checks: readonly Check[];
  /** No reply to the check of the code. */
  readonly isUnreachable: boolean;
  /** Why joining failed; empty when it did not. */
  readonly trouble: string;
  readonly isJoining: boolean;
  /** The page that opens uses sensors. */
  readonly usesSensors: boolean;
  /** How often the person refused motion on this page. */
  readonly refusals: number;
}

const AWAY: JoinRow = {
  tone: 'err',
  title: 'No connection to the host',
  text: 'Use the same Wi-Fi as the host. Turn off mobile data and VPN.',
};

/** The row for the worst finding; `undefined` while everything that this phone needs works. */
export function joinRow(facts: JoinRowFacts): JoinRow | undefined {
  const { checks, isUnreachable, trouble, isJoining } = facts;
  const has = (id: CheckId, state: Check['state']): Check | undefined =>
    checks.find((check) => check.id === id && check.state === state);
  if (isUnreachable || has('master', 'failed')) return AWAY;
  if (trouble !== '') {
    return isJoining
      ? { tone: 'warn', title: 'Waiting to join', text: trouble }
      : { tone: 'err', title: 'Joining failed', text: trouble };
  }
  const channel = has('channel', 'failed');
  if (channel !== undefined) {
    const text = 'Pages open, but nothing is sent or received.';
    return withRemedy({ tone: 'warn', title: 'Live connection is blocked', text }, channel);
  }
  return sensorRow(facts, has) ?? clockRow(has('clock', 'warning'));
}

function sensorRow(
  { usesSensors, refusals }: JoinRowFacts,
  has: (id: CheckId, state: Check['state']) => Check | undefined,
): JoinRow | undefined {
  if (!usesSensors) return undefined;
  const insecure = has('secure', 'warning');
  if (insecure !== undefined) {
    const text = 'Touch and buttons work. Motion and camera need the secure page.';
    return withRemedy({ tone: 'warn', title: 'This page is not secure', text }, insecure);
  }
  if (refusals > 0) {
    return {
      tone: 'warn',
      title: 'Motion is blocked',
      text:
        refusals < 2
          ? 'Touch and buttons work. Tap Allow in the browser’s prompt to send motion.'
          : 'Touch and buttons work. To be asked again, close the browser completely and scan again.',
      remedy: 'ask-again',
    };
  }
  if (has('sensors', 'warning') === undefined) return undefined;
  return {
    tone: 'warn',
    title: 'No motion arrives',
    text: 'Touch and buttons work. The browser may block motion in its site settings.',
  };
}

function clockRow(clock: Check | undefined): JoinRow | undefined {
  if (clock === undefined) return undefined;
  const text = 'Times on this phone are wrong until its clock is set. All else works.';
  return { tone: 'warn', title: 'The clock is off', text };
}

function withRemedy(row: JoinRow, { remedy }: Check): JoinRow {
  return remedy === undefined ? row : { ...row, remedy };
}
