import type { UbiiClient } from '@ubii/client-web';
import { preflightTopic } from '@ubii/proto';
import * as v from 'valibot';
import { describeAgent } from '../../../connection/agent-description.ts';
import { readStored } from '../../../json/read-stored.ts';
import { finite, textCutAt, validElements } from '../../../json/schemas.ts';
import type { Check } from './check.ts';

/** Topics of the preflight reports of all clients. [AC-30] */
export const PREFLIGHT_TOPICS = preflightTopic('*');

/** Report to the host. */
export interface PreflightReport {
  readonly version: 1;
  /** Time of measurement, epoch milliseconds of the device's clock. */
  readonly atMs: number;
  /** Short description of the device. */
  readonly agent: string;
  /** Origin of the page as used by the device. */
  readonly address: string;
  readonly checks: readonly Pick<Check, 'id' | 'state' | 'title' | 'text' | 'value'>[];
}

/** Publishes the report for the host; allowed for every role. */
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

const MAX_CHECKS = 10;
const MAX_TEXT_CHARS = 400;
/** Longest report, characters: all checks with their longest texts. */
const MAX_REPORT_CHARS = 40_000;

const words = textCutAt(MAX_TEXT_CHARS);

const REPORT = v.object({
  version: v.literal(1),
  atMs: v.fallback(finite, 0),
  agent: words,
  address: words,
  checks: validElements(
    v.object({
      id: v.picklist(['master', 'secure', 'channel', 'clock', 'sensors']),
      state: v.picklist(['good', 'warning', 'failed', 'asks', 'none']),
      title: words,
      text: words,
      value: words,
    }),
    MAX_CHECKS,
  ),
});

/** Parses a record of another client; `undefined` when it is not a report. */
export const readReport = (text: string): PreflightReport | undefined =>
  readStored(REPORT, text, MAX_REPORT_CHARS);
