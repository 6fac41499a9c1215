import type { Setting } from '@ubii/proto';

/** What follows when something takes too much, in one sentence; `undefined` when it is not told. [EX-48] */
export function checksSentence(settings: readonly Setting[]): string | undefined {
  const valueOf = (flag: string): string | undefined =>
    settings.find((setting) => setting.flag === flag)?.value;
  const checks = valueOf('--checks');
  const bounds = `when its main-thread load is above ${valueOf('--busy-percent')} %, or one client causes more than ${valueOf('--publisher-percent')} %`;
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
