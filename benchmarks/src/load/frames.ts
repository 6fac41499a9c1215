import { OPCODE } from './frame-reader.ts';

/** Not random as RFC 6455 asks for: no proxy is in between, and every run sends the same bytes. */
const MASK = Buffer.from([0x5a, 0xc3, 0x17, 0x8e]);

const MASKED = 0x80;
const FINAL = 0x80;

/** One masked frame as a client sends it; brokers have to unmask it, as they have to for any client. */
export function clientFrame(opcode: number, payload: Uint8Array): Buffer {
  const head = headOf(opcode, payload.length, MASKED);
  const frame = Buffer.allocUnsafe(head.length + MASK.length + payload.length);
  frame.set(head);
  frame.set(MASK, head.length);
  const start = head.length + MASK.length;
  for (let i = 0; i < payload.length; i += 1) frame[start + i] = payload[i]! ^ MASK[i & 3]!;
  return frame;
}

/** One unmasked frame as a server sends it. @param opcode default: binary */
export function serverFrame(payload: Uint8Array, opcode: number = OPCODE.binary): Buffer {
  return Buffer.concat([headOf(opcode, payload.length, 0), payload]);
}

/** Opcode and length of a frame, RFC 6455 section 5.2. @param masked the bit for masked frames, or 0 */
function headOf(opcode: number, length: number, masked: number): Buffer {
  if (length < 126) return Buffer.from([FINAL | opcode, masked | length]);
  const isShort = length <= 0xffff;
  const head = Buffer.alloc(isShort ? 4 : 10);
  head[0] = FINAL | opcode;
  head[1] = masked | (isShort ? 126 : 127);
  if (isShort) head.writeUInt16BE(length, 2);
  else head.writeUInt32BE(length, 6);
  return head;
}
