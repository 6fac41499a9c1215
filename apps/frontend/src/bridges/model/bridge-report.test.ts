import { describe, expect, it } from 'vitest';
import { isFresh, ratesBetween, sumRates } from './bridge-rates.ts';
import { bridgeOfTopic, readBridgeReport, type BridgeReport } from './bridge-report.ts';
import { bridgeState } from './bridge-state.ts';

const lane = { passed: 4, refused: 1, dropped: 0, returned: 0, topics: 2 };
/** A report as a bridge writes it that is connected, and was refused nothing: members without a value are missing. */
const written = {
  version: 1,
  protocol: 'mqtt',
  system: 'mqtt hall:1883',
  file: '/srv/bridge.json',
  revision: 'r1',
  status: 'connected',
  overRate: 0,
  refused: 0,
  mappings: [{ name: 'lamps', direction: 'in', foreign: 'a/+', topic: '/{1}', in: lane }],
};
const read = (changes: object = {}): BridgeReport | undefined =>
  readBridgeReport(JSON.stringify({ ...written, ...changes }));
const stateOf = (changes: object) => bridgeState({ isHere: true, report: read(changes) });

describe('report of a bridge', () => {
  it('is read without the members that a bridge sends only when it has them [BR-33]', () => {
    expect(read()).toMatchObject({ status: 'connected', reason: '', lastRefusal: '' });
    expect(read()?.mappings).toEqual([
      {
        name: 'lamps',
        in: { ...lane, evicted: 0, lastError: undefined, lastValue: undefined },
        out: undefined,
      },
    ]);
  });

  it('of another version, or that is none, is not read', () => {
    expect(read({ version: 2 })).toBeUndefined();
    expect(readBridgeReport('{')).toBeUndefined();
    expect(read({ mappings: 'all' })).toBeUndefined();
  });

  it('loses a mapping that is damaged, and no other', () => {
    const names = read({ mappings: [7, ...written.mappings] })?.mappings.map(({ name }) => name);
    expect(names).toEqual(['lamps']);
  });

  it('comes on a topic of the bridge', () => {
    expect(bridgeOfTopic('/f3/bridge')).toBe('f3');
    expect(bridgeOfTopic('/f3/hall/bridge')).toBeUndefined();
  });
});

describe('state of a bridge', () => {
  it('is that of its report', () => {
    expect(stateOf({})).toMatchObject({ mark: 'live', word: 'Connected', sentence: '' });
    expect(stateOf({ status: 'waiting', reason: 'connection refused.' })).toMatchObject({
      mark: 'warning',
      sentence:
        'No connection to mqtt hall:1883: connection refused. It retries until it succeeds.',
    });
  });

  it('is unknown before the first report, and left when the client is gone', () => {
    expect(bridgeState({ isHere: true, report: undefined }).word).toBe('Starting');
    expect(stateOf({ isStandingBy: true }).word).toBe('Standing by');
    expect(bridgeState({ isHere: false, report: read() }).word).toBe('Left');
  });
});

describe('rates of a bridge', () => {
  const at = (passed: number, atMs: number, name = 'lamps') => ({
    report: read({ mappings: [{ name, in: { ...lane, passed } }] })!,
    atMs,
  });

  it('are the records between two reports', () => {
    const rates = ratesBetween(at(4, 1_000), at(14, 2_000));
    expect(rates.get('lamps')).toEqual({ in: 10, out: 0 });
    expect(sumRates([...rates.values(), { in: 1, out: 2 }])).toEqual({ in: 11, out: 2 });
  });

  it('count a pause without reports as one without records', () => {
    expect(ratesBetween(at(4, 0), at(7, 60_000)).get('lamps')?.in).toBe(2);
  });

  it('are 0 for counters that were started again, and for new mappings', () => {
    expect(ratesBetween(at(9, 0), at(2, 1_000)).get('lamps')?.in).toBe(0);
    expect(ratesBetween(at(9, 0), at(2, 1_000, 'new')).get('new')?.in).toBe(0);
  });

  it('hold for 2.5 s', () => {
    expect(isFresh(at(1, 1_000), 3_499)).toBe(true);
    expect(isFresh(at(1, 1_000), 3_500)).toBe(false);
  });
});
