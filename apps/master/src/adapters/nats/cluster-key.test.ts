import { expect, it } from 'vitest';

import { HmacMessageSeal } from './cluster-key.ts';

const message = Buffer.from('message');
const seal = new HmacMessageSeal(new Uint8Array(32).fill(1));

it('[CU-65] a proof is worth nothing for another message, sender or receiver, and with another key', () => {
  const proof = seal.prove('a', 'b', message);
  expect(proof).toHaveLength(32);
  expect(seal.verify('a', 'b', message, proof)).toBe(true);
  expect(new HmacMessageSeal(new Uint8Array(32).fill(1)).verify('a', 'b', message, proof)).toBe(
    true,
  );
  expect([
    seal.verify('a', 'b', Buffer.from('massage'), proof),
    seal.verify('c', 'b', message, proof),
    seal.verify('a', '', message, proof),
    seal.verify('a', 'b', message, proof.subarray(1)),
    seal.verify('a', 'b', message, new Uint8Array(0)),
    new HmacMessageSeal(new Uint8Array(32)).verify('a', 'b', message, proof),
  ]).toEqual(Array(6).fill(false));
});
