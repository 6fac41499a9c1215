const OPCODE_BINARY_FINAL = 0x82;

/** One unmasked binary frame that holds `payload`. */
export function binaryFrameOf(payload) {
  const length = payload.length;
  let frame;
  let start;
  if (length < 126) {
    start = 2;
    frame = Buffer.allocUnsafe(start + length);
    frame[1] = length;
  } else if (length < 0x10000) {
    start = 4;
    frame = Buffer.allocUnsafe(start + length);
    frame[1] = 126;
    frame.writeUInt16BE(length, 2);
  } else {
    start = 10;
    frame = Buffer.allocUnsafe(start + length);
    frame[1] = 127;
    frame.writeUInt32BE(0, 2);
    frame.writeUInt32BE(length, 6);
  }
  frame[0] = OPCODE_BINARY_FINAL;
  frame.set(payload, start);
  return frame;
}
