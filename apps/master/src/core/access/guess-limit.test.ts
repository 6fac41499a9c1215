import { FakeClock } from '@ubii/timing/testing';
import { describe, expect, it } from 'vitest';

import { RecordingLog } from '../../testing/index.ts';
import { DEFAULT_LIMITS } from '../limits/index.ts';
import { EventLog } from '../counters/event-log.ts';
import { LimitWatch } from '../counters/limit-watch.ts';
import { GuessLimit } from './guess-limit.ts';

/** Longest lifetime of a code, seconds. [AC-11] */
const CODE_LIFETIME_S = 12 * 3_600;

function world() {
  const clock = new FakeClock();
  const log = new RecordingLog();
  const guesses = new GuessLimit(
    clock,
    new LimitWatch(DEFAULT_LIMITS, clock, log, new EventLog(clock, log, DEFAULT_LIMITS)),
  );
  let looked = 0;
  /** Tries a wrong code. @returns whether the code was checked */
  const tryWrong = (place: string, address?: string): boolean => {
    const source = { place, address };
    if (!guesses.mayTry(source)) return false;
    looked++;
    guesses.countWrong(source);
    return true;
  };
  /** Has so many seconds pass, in each of which `each` is called `times`, at even distances. */
  const during = (seconds: number, times: number, each: (n: number) => void): void => {
    for (let n = 0; n < seconds * times; n++) {
      each(n);
      clock.advanceSync(1_000 / times);
    }
  };
  return { clock, guesses, tryWrong, during, looked: () => looked };
}

describe('the pace of wrong codes [AC-17]', () => {
  it('accepts a valid code at once from the address of ten wrong codes per second', () => {
    const { guesses, tryWrong, during } = world();
    let refused = 0;
    during(600, 10, () => {
      tryWrong('10.0.0.1');
      if (!guesses.mayTry({ place: '10.0.0.1', address: '10.0.0.1' })) refused++;
    });
    expect(refused).toBe(0);
  });

  it('lets neighbours in at once, in the network of 64 bits of an address that tries as fast as it can', () => {
    const { guesses, tryWrong, during } = world();
    let refused = 0;
    during(60, 200, () => {
      tryWrong('fd00:0:0:0', 'fd00::1');
      if (!guesses.mayTry({ place: 'fd00:0:0:0', address: 'fd00::2' })) refused++;
    });
    expect(refused).toBe(0);
  });

  it('looks at ten a second of an address, and at twenty of a network with ever new ones', () => {
    const one = world();
    one.during(60, 200, () => one.tryWrong('10.0.0.1', '10.0.0.1'));
    expect(one.looked()).toBeGreaterThanOrEqual(600);
    expect(one.looked()).toBeLessThanOrEqual(620);
    const network = world();
    network.during(60, 200, (n) => network.tryWrong('fd00:0:0:0', `fd00::${n}`));
    expect(network.looked()).toBeGreaterThanOrEqual(1_200);
    expect(network.looked()).toBeLessThanOrEqual(1_240);
  });

  it('admits new clients at once, from whatever number of addresses others try', () => {
    const { guesses, tryWrong, during } = world();
    let refused = 0;
    during(20, 1_000, (n) => {
      tryWrong(`10.0.0.${n % 250}`);
      if (n % 100 === 0 && !guesses.mayTry({ place: `10.1.0.${n}` })) refused++;
    });
    // In the first second all addresses are new.
    expect(refused).toBeLessThanOrEqual(10);
  });

  it('admits a caller with a few wrong codes within seconds, while 250 addresses try', () => {
    const { guesses, tryWrong, during, clock } = world();
    during(10, 1_000, (n) => tryWrong(`10.0.0.${n % 250}`));
    const mistaken = { place: '10.1.0.1' };
    for (let i = 0; i < 3; i++) tryWrong('10.1.0.1');
    const fromMs = clock.monotonicMs();
    let waitedMs: number | undefined;
    during(20, 1_000, (n) => {
      tryWrong(`10.0.0.${n % 250}`);
      if (waitedMs === undefined && n % 1_000 === 500 && guesses.mayTry(mistaken)) {
        waitedMs = clock.monotonicMs() - fromMs;
      }
    });
    expect(waitedMs).toBeLessThan(10_000);
  });

  it('keeps a code from being found, however many try', () => {
    const { tryWrong, during, looked } = world();
    // Each time a place that was never seen, the best that an attacker can do.
    during(20, 1_000, (n) => tryWrong(`place ${n}`));
    const perSecond = looked() / 20;
    expect(perSecond).toBeLessThanOrEqual(DEFAULT_LIMITS.wrongCodes);
    const { wrongCodes, wrongCodesPerNetwork } = DEFAULT_LIMITS;
    const chance = (rate: number) => (rate * CODE_LIFETIME_S) / 2 ** 40;
    expect(chance(wrongCodes)).toBeLessThan(1e-5);
    expect(chance(wrongCodesPerNetwork)).toBeLessThan(1e-6);
  });

  it('forgets places that were not wrong for a minute', () => {
    const { clock, guesses, tryWrong } = world();
    while (tryWrong('10.0.0.1'));
    clock.advanceSync(60_000);
    expect(guesses.mayTry({ place: '10.0.0.1' })).toBe(true);
  });
});
