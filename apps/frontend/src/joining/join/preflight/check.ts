/** Checks of a preflight, in display order. [AC-30] */
export type CheckId = 'master' | 'secure' | 'channel' | 'clock' | 'sensors';

/**
 * `checking`, `good`, `warning`: joining works with restrictions, `failed`, `asks`: needs the user's permission,
 * `none`: not applicable to this device
 */
export type CheckState = 'checking' | 'good' | 'warning' | 'failed' | 'asks' | 'none';

/** Result of a check. */
export interface Check {
  readonly id: CheckId;
  readonly state: CheckState;
  readonly title: string;
  /** Finding; for a failure, its likely causes and the remedy. */
  readonly text: string;
  /** With unit: `9 ms`. */
  readonly value?: string;
  /** Link to the remedy. */
  readonly remedy?: { readonly text: string; readonly href: string };
}

/** Initial state of all checks. */
export function openChecks(): readonly Check[] {
  return [
    { id: 'master', state: 'checking', title: 'Host', text: 'Checking' },
    { id: 'secure', state: 'checking', title: 'Secure page', text: 'Checking' },
    { id: 'channel', state: 'checking', title: 'Live connection', text: 'Opening' },
    { id: 'clock', state: 'checking', title: 'Clock', text: 'Comparing' },
    { id: 'sensors', state: 'checking', title: 'Motion sensors', text: 'Checking' },
  ];
}
