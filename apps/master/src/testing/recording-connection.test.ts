import { settle } from '@ubii/timing/testing';
import { handleText } from '../adapters/heartbeat/handle-text.ts';
import { LOCAL_CALLER, type ConnectionHandle } from '../core/ports/index.ts';
import { clientConnectionSuite, pingText, type ClientEnd } from './acceptance/index.ts';
import { RecordingConnection } from './recording-connection.ts';

/** What a `TestClient` does: it calls the master's side itself. */
clientConnectionSuite('RecordingConnection', (host) => ({
  dial(claim): ClientEnd {
    const connection = new RecordingConnection();
    const isRefused = host.refuseConnection(claim, LOCAL_CALLER) !== undefined;
    const handle = isRefused ? undefined : host.openConnection(claim, connection, LOCAL_CALLER);
    return endOf(connection, handle);
  },
  caller: LOCAL_CALLER,
  tells: { program: undefined, token: true, reason: true, leaving: true },
  settle,
  close: () => undefined,
}));

function endOf(connection: RecordingConnection, handle: ConnectionHandle | undefined): ClientEnd {
  const send = (text: string): void => {
    if (handle !== undefined) handleText(handle, text);
  };
  return {
    next: () => Promise.resolve(connection.sent.shift()!),
    ended: () => Promise.resolve(),
    sendTopicData: (bytes) => handle?.handleTopicData(bytes.slice()),
    sendPing: (timed) => send(pingText(timed)),
    sendPong: () => send('PONG'),
    sendNonsense: () => send('neither PING nor PONG'),
    leave: () => handle?.handleClose('left'),
    cut: () => handle?.handleClose('lost'),
    pause: () => connection.stall(0),
    resume() {
      connection.take();
      handle?.handleDrain();
    },
  };
}
