/** Not random as RFC 6455 asks for: no proxy is in between, and every run sends the same bytes. */
const MASK = Buffer.from([0x5a, 0xc3, 0x17, 0x8e]);

const MASKED = 0x80;
const FINAL = 0x80;

/** One masked frame as a client sends it; brokers have to unmask it, as they have to for any client. */
export function clientFrame(opcode: number, payload: Uint8Array): Buffer {
  const length = payload.length;
  if (length > 0xffff) throw new RangeError(`Expected at most 65535 bytes, received ${length}.`);
  const maskAt = length < 126 ? 2 : 4;
  const frame = Buffer.allocUnsafe(maskAt + 4 + length);
  frame[0] = FINAL | opcode;
  if (length < 126) {
    frame[1] = MASKED | length;
  } else {
    frame[1] = MASKED | 126;
    frame.writeUInt16BE(length, 2);
  }
  frame.set(MASK, maskAt);
  for (let i = 0; i < length; i += 1) frame[maskAt + 4 + i] = payload[i]! ^ MASK[i & 3]!;
  return frame;
}

/** One unmasked binary frame as a server sends it. */
export function serverFrame(payload: Uint8Array): Buffer {
  const length = payload.length;
  if (length > 0xffff) throw new RangeError(`Expected at most 65535 bytes, received ${length}.`);
  const start = length < 126 ? 2 : 4;
  const frame = Buffer.allocUnsafe(start + length);
  frame[0] = 0x82;
  if (length < 126) {
    frame[1] = length;
  } else {
    frame[1] = 126;
    frame.writeUInt16BE(length, 2);
  }
  frame.set(payload, start);
  return frame;
}
