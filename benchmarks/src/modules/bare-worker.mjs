/**
 * The limit that calls of modules are measured against: a worker that gets a message and answers it,
 * and does nothing for it but what the module does.
 */
import { parentPort } from 'node:worker_threads';

parentPort.on('message', ({ record, picture }) => {
  if (picture === undefined) {
    parentPort.postMessage(record);
    return;
  }
  const { data, offset, length } = picture;
  const middle = data[offset + (length >> 1)];
  parentPort.postMessage(data[offset] + 256 * middle + 65536 * data[offset + length - 1]);
});
