const MIB = 1024 * 1024;
/** Below what any build takes as one body. */
const SIZE = 31 * MIB;

/** A request to save a session, as JSON, of some 31 MiB. */
export const LARGE_BODIES: Readonly<Record<string, () => Buffer>> = {
  nested: () => {
    const half = (SIZE - 100) / 2;
    return wrap(Buffer.concat([Buffer.alloc(half, '['), Buffer.alloc(half, ']')]));
  },
  keys: () => {
    const parts: string[] = [];
    for (let index = 0, size = 0; size < SIZE - 200; index++) {
      const part = `"k${index.toString(36)}":1`;
      parts.push(part);
      size += part.length + 1;
    }
    return wrap(Buffer.from(`{${parts.join(',')}}`));
  },
  objects: () => {
    const one = '{"name":"a"},';
    const list = Buffer.alloc(Math.floor((SIZE - 200) / one.length) * one.length, one);
    return wrap(Buffer.concat([Buffer.from('{"processingModules":['), list, Buffer.from('{}]}')]));
  },
};

function wrap(session: Buffer): Buffer {
  const topic = '/services/session/database/save';
  return Buffer.concat([Buffer.from(`{"topic":"${topic}","session":`), session, Buffer.from('}')]);
}
