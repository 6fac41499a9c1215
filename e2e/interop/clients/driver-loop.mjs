// Common part of all JavaScript drivers: one JSON object per line on stdin (a command with an id), one per line on
// stdout (its reply, or an event). The clients write their own messages to stdout; those are redirected to stderr.

import { createInterface } from 'node:readline';

const writeLine = process.stdout.write.bind(process.stdout);
process.stdout.write = process.stderr.write.bind(process.stderr);

/** Sends an event to the test: `{ event, ...fields }`. */
export function emit(event, fields = {}) {
  writeLine(`${JSON.stringify({ event, ...fields })}\n`);
}

/** Answers commands from `commands` (name -> async function of the parameters) until stdin closes. */
export function serve(commands) {
  for (const level of ['warn', 'error']) {
    console[level] = (...parts) => {
      const text = parts.map((part) => part?.stack ?? String(part)).join(' ');
      process.stderr.write(`${text}\n`);
      emit('complaint', { text });
    };
  }
  const lines = createInterface({ input: process.stdin });
  lines.on('line', async (line) => {
    const { id, command, params } = JSON.parse(line);
    try {
      const result = await commands[command](params ?? {});
      writeLine(`${JSON.stringify({ id, result: result ?? null })}\n`);
    } catch (error) {
      writeLine(`${JSON.stringify({ id, error: String(error?.stack ?? error) })}\n`);
    }
  });
  lines.on('close', () => process.exit(0));
  emit('ready');
}

/** Tells the test what kind of frame came: `ping`, `text`, `record`, `list`, `error` or `empty`. */
export function emitFrame(data, decodeTopicData) {
  if (typeof data === 'string') {
    emit('frame', { kind: data === 'PING' ? 'ping' : 'text', text: data });
    return;
  }
  const message = decodeTopicData(new Uint8Array(data));
  if (message.topicDataRecordList) emit('frame', { kind: 'list' });
  else if (message.topicDataRecord)
    emit('frame', { kind: 'record', topic: message.topicDataRecord.topic });
  else if (message.error) emit('frame', { kind: 'error', text: message.error.message });
  else emit('frame', { kind: 'empty' });
}
