import { expect, it } from 'vitest';

import { parseDelivery } from './kv-watch.ts';

const FACTS = { revision: 42, number: 3, timeMs: 1_700_000_000_123, pending: 5 };

it('[CU-53] reads what servers of both generations say of a delivered value', () => {
  const old = '$JS.ACK.KV_bucket.consumer.1.42.3.1700000000123456789.5';
  const later = '$JS.ACK._.ACCHASH.KV_bucket.consumer.1.42.3.1700000000123456789.5.random';
  expect(parseDelivery(old)).toEqual(FACTS);
  expect(parseDelivery(later)).toEqual(FACTS);
});

it.each(['', '$JS.ACK', '$JS.FC.a.b.c.d.e.f.g', '$JS.ACK.s.c.1.x.3.4.5', 'a.b.c.d.e.f.g.h.i'])(
  '[CU-53] reads nothing from %j',
  (reply) => expect(parseDelivery(reply)).toBeUndefined(),
);
