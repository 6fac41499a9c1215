import { createServer, type AddressInfo } from 'node:net';
import { SystemClock } from '@ubii/timing/system';
import { Dealer } from 'zeromq';

import { TRUSTED_CALLER, type ConnectionHost } from '../../index.ts';
import {
  Inbox,
  clientConnectionSuite,
  pingText,
  readText,
  readTopicData,
  type ClientEnd,
  type ConnectionBench,
  type Seen,
} from '../../testing/acceptance/index.ts';
import { RecordingLog } from '../../testing/recording-log.ts';
import { ZeroMqTopicData } from './zeromq-topic-data.ts';

const MAX_MESSAGE_BYTES = 2_000_000;
/** Messages that the library of a client reads before the client asks for them. */
const READ_AHEAD = 1;
/** Time for the library to send what is left when a client leaves, milliseconds. */
const LINGER_MS = 5_000;

clientConnectionSuite('ZeroMqTopicData', openBench);

async function openBench(host: ConnectionHost): Promise<ConnectionBench> {
  const topicData = new ZeroMqTopicData({
    master: host,
    callers: { prepare: () => undefined, read: () => TRUSTED_CALLER },
    log: new RecordingLog(),
    clock: new SystemClock(),
    maxMessageBytes: MAX_MESSAGE_BYTES,
    greetingMs: 60_000,
    holdMs: 0,
  });
  const server = createServer((socket) => topicData.handleConnection(socket));
  await new Promise<void>((resolve) => server.listen(0, '127.0.0.1', resolve));
  const { port } = server.address() as AddressInfo;
  const dealers: Dealer[] = [];
  return {
    dial({ clientId }) {
      const dealer = new Dealer({
        ...(clientId !== undefined && { routingId: clientId }),
        receiveHighWaterMark: READ_AHEAD,
        linger: 0,
      });
      dealers.push(dealer);
      return endOf(dealer, `tcp://127.0.0.1:${port}`);
    },
    caller: TRUSTED_CALLER,
    tells: { program: undefined, token: false, reason: false, leaving: false },
    settle: () => new Promise((resolve) => setImmediate(resolve)),
    async close() {
      for (const dealer of dealers) dealer.close();
      topicData.terminate();
      await new Promise((resolve) => server.close(resolve));
    },
  };
}

/** What a program at the other end does. */
function endOf(dealer: Dealer, address: string): ClientEnd {
  const seen = new Inbox<Seen>();
  const ended = new Promise<void>((resolve) => dealer.events.on('disconnect', () => resolve()));
  dealer.connect(address);
  let isReading = true;
  let readOn = (): void => undefined;
  void (async () => {
    for await (const [delimiter, content] of dealer) {
      // Pitfall 15: existing clients take the second frame.
      if (delimiter?.length !== 0 || content === undefined) throw new Error('no delimiter came');
      seen.add(readContent(content));
      if (!isReading) await new Promise<void>((resolve) => (readOn = resolve));
    }
  })();
  let sent = Promise.resolve();
  const send = (...frames: (string | Uint8Array)[]): void => {
    const copies = frames.map((frame) => Buffer.from(frame));
    sent = sent.then(() => dealer.send(copies));
  };
  return {
    next: () => seen.next(),
    ended: () => ended,
    sendTopicData: (bytes) => send(bytes),
    sendPing: (timed) => send(pingText(timed)),
    sendPong: () => send('PONG'),
    sendNonsense: () => send('one', 'two', 'three'),
    leave() {
      dealer.linger = LINGER_MS;
      void sent.then(() => dealer.close());
    },
    cut: () => void sent.then(() => dealer.close()),
    pause() {
      isReading = false;
    },
    resume() {
      isReading = true;
      readOn();
    },
  };
}

function readContent(content: Buffer): Seen {
  const text = content.toString('latin1');
  return /^P[IO]NG/.test(text) ? readText(text) : readTopicData(content);
}
