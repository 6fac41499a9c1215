import type { Setting } from '@ubii/proto';

/** What follows when something takes too much, in one sentence; `undefined` when it is not told. [EX-48] */
export function checksSentence(settings: readonly Setting[]): string | undefined {
  const valueOf = (flag: string): string | undefined =>
    settings.find((setting) => setting.flag === flag)?.value;
  const checks = valueOf('--checks');
  const bounds = `when it is busy for more than ${valueOf('--busy-percent')} % of the time, or one client takes more than ${valueOf('--publisher-percent')} %`;
  switch (checks) {
    case 'off':
      return 'Checks are off: nobody is warned when the master has too much to do.';
    case 'warn':
      return `Checks warn ${bounds}.`;
    case 'throttle':
      return `Checks warn ${bounds}, and noisy publishers are throttled.`;
    default:
      return undefined;
  }
}
