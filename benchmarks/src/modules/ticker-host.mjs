/**
 * The limit that modules at a frequency are measured against: timers that send a message to one worker,
 * which runs the same code, writes the record, and sends it back to be passed on to a subscriber. Not a
 * product: no topics, no checks, no limits, no reports.
 *
 * Plain JavaScript, so that it runs in the same plain Node as the built master.
 *
 * argv: file with { source, hertz, records: [{ base64, offset }] }; the doubles of a record are at its offset.
 */
import { readFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { isMainThread, parentPort, Worker, workerData } from 'node:worker_threads';

if (isMainThread) host();
else work();

function work() {
  const onProcessing = (0, eval)(`(${workerData.source})`);
  const modules = workerData.records.map(({ base64, offset }) => {
    const bytes = Uint8Array.from(Buffer.from(base64, 'base64'));
    return { state: {}, bytes, view: new DataView(bytes.buffer), offset };
  });
  parentPort.on('message', ({ index, deltaTimeMs }) => {
    if (index < 0) {
      for (const module of modules) module.state = {};
      return;
    }
    const { state, bytes, view, offset } = modules[index];
    const { x, y, z } = onProcessing(deltaTimeMs, {}, state).outputs.out.vector3;
    view.setFloat64(offset, x, true);
    view.setFloat64(offset + 9, y, true);
    view.setFloat64(offset + 18, z, true);
    parentPort.postMessage(bytes);
  });
}

async function host() {
  const { WebSocketServer } = await import('ws');
  const setting = JSON.parse(readFileSync(process.argv[2], 'utf8'));
  const worker = new Worker(new URL(import.meta.url), { workerData: setting });
  const intervalMs = 1000 / setting.hertz;
  let timers = [];
  let subscriber;
  let waiting = [];

  worker.on('message', (record) => {
    if (waiting.push(record) === 1) setImmediate(flush);
  });

  /** Records of one turn leave together, as they do on the master. */
  function flush() {
    const records = waiting;
    waiting = [];
    const elements = records.map((record) =>
      Buffer.concat([delimited(0x0a, record.length), record]),
    );
    const list = Buffer.concat(elements);
    subscriber?.send(Buffer.concat([delimited(0x1a, list.length), list]));
  }

  function start() {
    worker.postMessage({ index: -1 });
    timers = setting.records.map((_record, index) => {
      const timer = { handle: undefined };
      let startMs = 0;
      let lastMs = 0;
      let run = 0;
      const due = () => {
        const nowMs = performance.now();
        run += 1;
        while (startMs + run * intervalMs <= nowMs) run += 1;
        timer.handle = setTimeout(due, startMs + run * intervalMs - nowMs);
        worker.postMessage({ index, deltaTimeMs: nowMs - lastMs });
        lastMs = nowMs;
      };
      const begin = () => {
        startMs = performance.now();
        lastMs = startMs;
        due();
      };
      // Modules are made one after the other, so that each has moments of its own.
      timer.handle = setTimeout(begin, (index * intervalMs) / setting.records.length);
      return timer;
    });
  }

  const http = createServer();
  const server = new WebSocketServer({ server: http, perMessageDeflate: false });
  server.on('connection', (connection, request) => {
    request.socket.setNoDelay(true);
    subscriber = connection;
    start();
    connection.on('error', () => connection.terminate());
    connection.on('close', () => {
      for (const { handle } of timers) clearTimeout(handle);
      subscriber = undefined;
    });
  });
  http.listen(0, '127.0.0.1', () => {
    const { port } = http.address();
    process.stdout.write(`${JSON.stringify({ url: `ws://127.0.0.1:${port}/` })}\n`);
  });
  process.on('SIGTERM', () => process.exit(0));
}

/** Tag and length, protobuf's. */
function delimited(tag, length) {
  const bytes = [tag];
  let rest = length;
  for (; rest > 0x7f; rest >>>= 7) bytes.push((rest & 0x7f) | 0x80);
  bytes.push(rest);
  return Buffer.from(bytes);
}
