import { expect, it } from 'vitest';
import { PeerRoundTrip } from './peer-round-trip.ts';

it('[CU-74] measures the way there and back, without the time that the other master held it', () => {
  const a = new PeerRoundTrip();
  const b = new PeerRoundTrip();
  // The clocks began at different times: a's 10 is b's 5010. Each way takes 3 ms.
  const first = a.times(10);
  expect(first).toEqual({ sentMs: 10, echoMs: 0, heldMs: 0 });
  b.handleTimes(first, 5_013);
  const answer = b.times(5_400);
  a.handleTimes(answer, 403);
  expect(a.latestMs).toBe(6);
  // b has no answer of its own yet.
  expect(b.latestMs).toBe(0);
});

it('[CU-74] keeps the last measurement when parts without times come', () => {
  const trip = new PeerRoundTrip();
  trip.handleTimes({ sentMs: 1, echoMs: 10, heldMs: 2 }, 20);
  trip.handleTimes({ sentMs: 0, echoMs: 0, heldMs: 0 }, 90);
  expect(trip.latestMs).toBe(8);
  expect(trip.times(100)).toEqual({ sentMs: 100, echoMs: 1, heldMs: 80 });
});
