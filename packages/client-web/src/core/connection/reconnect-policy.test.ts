import { describe, expect, it } from 'vitest';
import { DEFAULT_RECONNECT_POLICY, reconnectDelayMs } from './reconnect-policy.ts';

const policy = { ...DEFAULT_RECONNECT_POLICY, initialDelayMs: 100, factor: 2, maxDelayMs: 1_000 };
const never = () => 0;
const almostOne = () => 0.999_999;

describe('reconnectDelayMs()', () => {
  it('grows by the factor up to the cap', () => {
    const delaysMs = [0, 1, 2, 3, 4, 50, 5_000].map((failed) =>
      reconnectDelayMs(policy, failed, never),
    );
    expect(delaysMs).toEqual([100, 200, 400, 800, 1_000, 1_000, 1_000]);
  });

  it('stays short without an answer, so that a restarted master is found within 2 s [CL-43]', () => {
    const { maxUnansweredDelayMs } = DEFAULT_RECONNECT_POLICY;
    expect(maxUnansweredDelayMs).toBeLessThan(2_000);
    for (const failed of [4, 50, 5_000]) {
      expect(reconnectDelayMs(DEFAULT_RECONNECT_POLICY, failed, never, false)).toBe(
        maxUnansweredDelayMs,
      );
    }
    expect(reconnectDelayMs({ ...policy, maxDelayMs: 500 }, 50, never, false)).toBe(500);
  });

  it('leaves its share to chance, and no more', () => {
    expect(reconnectDelayMs(policy, 1, almostOne)).toBeCloseTo(100, 2);
    expect(reconnectDelayMs({ ...policy, jitter: 1 }, 1, almostOne)).toBeCloseTo(0, 2);
    expect(reconnectDelayMs({ ...policy, jitter: 0 }, 1, almostOne)).toBe(200);
  });

  it('gives up after so many failed attempts', () => {
    const patient = { ...policy, giveUpAfterAttempts: 2 };
    expect(reconnectDelayMs(patient, 1, never)).toBe(200);
    expect(reconnectDelayMs(patient, 2, never)).toBeUndefined();
  });

  it('never reconnects when told to give up after 0', () => {
    expect(reconnectDelayMs({ ...policy, giveUpAfterAttempts: 0 }, 0, never)).toBeUndefined();
  });
});
