// Loaded into a master under test: on SIGUSR2 it writes what the process holds, after a garbage collection.
// The file it writes to is in its own address: probe.mjs?<path>. Needs --expose-gc.
import { renameSync, writeFileSync } from 'node:fs';

const file = decodeURIComponent(new URL(import.meta.url).search.slice(1));
let count = 0;

process.on('SIGUSR2', () => {
  // A second one takes what the finalizers of the first let go.
  globalThis.gc();
  setImmediate(() => {
    globalThis.gc();
    const { heapUsed, external } = process.memoryUsage();
    const resources = {};
    for (const name of process.getActiveResourcesInfo()) {
      resources[name] = (resources[name] ?? 0) + 1;
    }
    writeFileSync(`${file}.tmp`, JSON.stringify({ count: ++count, heapUsed, external, resources }));
    renameSync(`${file}.tmp`, file);
  });
});
