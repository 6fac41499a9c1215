import fc from 'fast-check';

/** Encoded messages with a few bytes changed, put in, taken out, or cut off. */
export function damagedBytes(intact: fc.Arbitrary<Uint8Array>): fc.Arbitrary<Uint8Array> {
  const damage = fc.record({
    at: fc.double({ min: 0, max: 1, noNaN: true }),
    byte: fc.oneof(fc.constantFrom(0, 1, 0x7f, 0x80, 0xff, 0xc3), fc.nat(255)),
    kind: fc.constantFrom('change', 'insert', 'remove', 'cut'),
  });
  return fc.tuple(intact, fc.array(damage, { maxLength: 3 })).map(([bytes, damages]) => {
    const result = [...bytes];
    for (const { at, byte, kind } of damages) {
      const index = Math.floor(at * result.length);
      if (kind === 'change') result.splice(index, 1, byte);
      else if (kind === 'insert') result.splice(index, 0, byte);
      else if (kind === 'remove') result.splice(index, 1);
      else result.length = index;
    }
    return Uint8Array.from(result);
  });
}
