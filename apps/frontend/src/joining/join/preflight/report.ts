import type { UbiiClient } from '@ubii/client-web';
import { preflightTopic } from '@ubii/proto';
import { describeAgent } from '../../../connection/agent-description.ts';
import type { Check, CheckId, CheckState } from './check.ts';

/** Where pages say what their preflight found, of every client. [AC-30] */
export const PREFLIGHT_TOPICS = preflightTopic('*');

/** What is told the host. */
export interface PreflightReport {
  readonly version: 1;
  /** When it was measured: milliseconds since the Unix epoch, clock of the device. */
  readonly atMs: number;
  /** What the device is, in a few words. */
  readonly agent: string;
  /** Origin of the page, as the device reached it. */
  readonly address: string;
  readonly checks: readonly Pick<Check, 'id' | 'state' | 'title' | 'text' | 'value'>[];
}

/** Tells the host what was found; every role may. */
export function publishReport(client: UbiiClient, checks: readonly Check[]): void {
  const report: PreflightReport = {
    version: 1,
    atMs: Date.now(),
    agent: describeAgent(navigator.userAgent),
    address: location.origin,
    checks: checks
      .filter(({ state }) => state !== 'checking')
      .map(({ id, state, title, text, value }) => ({
        id,
        state,
        title,
        text,
        ...(value === undefined ? {} : { value }),
      })),
  };
  client.publish(preflightTopic(client.id), 'string', JSON.stringify(report), { immediate: true });
}

const IDS: readonly unknown[] = ['master', 'secure', 'channel', 'clock', 'sensors'];
const STATES: readonly unknown[] = ['good', 'warning', 'failed', 'asks', 'none'];

/** Reads what another client published; `undefined` when it is no report. */
export function readReport(text: string): PreflightReport | undefined {
  try {
    const report = JSON.parse(text) as Record<string, unknown> | null;
    if (report?.['version'] !== 1 || !Array.isArray(report['checks'])) return undefined;
    const checks = (report['checks'] as unknown[]).slice(0, 10).flatMap((one) => {
      const check = one as Record<string, unknown> | null;
      if (!IDS.includes(check?.['id']) || !STATES.includes(check?.['state'])) return [];
      return [
        {
          id: check!['id'] as CheckId,
          state: check!['state'] as CheckState,
          title: words(check!['title']),
          text: words(check!['text']),
          value: words(check!['value']),
        },
      ];
    });
    const atMs = Number(report['atMs']) || 0;
    return {
      version: 1,
      atMs,
      agent: words(report['agent']),
      address: words(report['address']),
      checks,
    };
  } catch {
    return undefined;
  }
}

/** Maximum length of texts from other programs. */
function words(value: unknown): string {
  return typeof value === 'string' ? value.slice(0, 400) : '';
}
