/**
 * The limit that calls of modules in browsers are measured against: a worker that gets a message and
 * answers it, and does nothing for it but what the module does.
 */
globalThis.onmessage = ({ data: { record, picture } }) => {
  if (picture === undefined) {
    globalThis.postMessage(record);
    return;
  }
  const { data, offset, length } = picture;
  const middle = data[offset + (length >> 1)];
  globalThis.postMessage(data[offset] + 256 * middle + 65536 * data[offset + length - 1]);
};
