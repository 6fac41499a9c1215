import type { ByteSource } from './byte-source.ts';
import { headerBytesOf, readFrameHeader, type FrameHeader } from './zmtp-frames.ts';

/** Takes the header of the next frame; its body follows. @throws ZmtpError, SourceEnded */
export async function takeFrameHeader(source: ByteSource, maxBytes: number): Promise<FrameHeader> {
  const [flags = 0] = await source.peek(1);
  const headerBytes = headerBytesOf(flags);
  return readFrameHeader(await source.take(headerBytes), 0, maxBytes);
}

/** A whole frame. */
export interface Frame extends FrameHeader {
  readonly body: Buffer;
}

/** Takes a small frame. @throws ZmtpError, SourceEnded */
export async function readFrame(source: ByteSource, maxBytes: number): Promise<Frame> {
  const header = await takeFrameHeader(source, maxBytes);
  return { ...header, body: await source.take(header.bodyBytes) };
}
