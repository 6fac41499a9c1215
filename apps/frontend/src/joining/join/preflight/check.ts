/** What a preflight looks at, in the order in which it is shown. [AC-30] */
export type CheckId = 'master' | 'secure' | 'channel' | 'clock' | 'sensors';

/**
 * `checking` · `good` · `warning`: joining works, something will be missing · `failed` · `asks`: the
 * person has to allow it · `none`: does not apply to this device
 */
export type CheckState = 'checking' | 'good' | 'warning' | 'failed' | 'asks' | 'none';

/** One measured fact. */
export interface Check {
  readonly id: CheckId;
  readonly state: CheckState;
  readonly title: string;
  /** What was found; of a failure its likely causes and what to do. */
  readonly text: string;
  /** With unit: `9 ms`. */
  readonly value?: string;
  /** Where the remedy is. */
  readonly remedy?: { readonly text: string; readonly href: string };
}

/** What is known before anything was measured. */
export function openChecks(): readonly Check[] {
  return [
    { id: 'master', state: 'checking', title: 'Master', text: 'Checking' },
    { id: 'secure', state: 'checking', title: 'Secure page', text: 'Checking' },
    { id: 'channel', state: 'checking', title: 'Live connection', text: 'Opening' },
    { id: 'clock', state: 'checking', title: 'Clock', text: 'Comparing' },
    { id: 'sensors', state: 'checking', title: 'Motion sensors', text: 'Checking' },
  ];
}
