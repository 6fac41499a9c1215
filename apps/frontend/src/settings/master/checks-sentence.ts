import type { Setting } from '@ubii/proto';

/** Describes the checks of the master in one sentence; `undefined` when the master does not report them. [EX-48] */
export function checksSentence(settings: readonly Setting[]): string | undefined {
  const valueOf = (flag: string): string | undefined =>
    settings.find((setting) => setting.flag === flag)?.value;
  const checks = valueOf('--checks');
  const bounds = `when the main-thread load is above ${valueOf('--busy-percent')} %, or the share of one client in it is above ${valueOf('--publisher-percent')} %`;
  switch (checks) {
    case 'off':
      return 'Checks are off: no warning appears when the master is overloaded.';
    case 'warn':
      return `Checks warn ${bounds}.`;
    case 'throttle':
      return `Checks warn ${bounds}, and noisy publishers are throttled.`;
    default:
      return undefined;
  }
}
