import { settle } from '@ubii/timing/testing';
import { handleText } from '../adapters/heartbeat/handle-text.ts';
import { LOCAL_CALLER, type ConnectionHandle } from '../core/ports/index.ts';
import { clientConnectionSuite, pingText, type ClientEnd } from './acceptance/index.ts';
import { RecordingConnection } from './recording-connection.ts';

/** What a `TestClient` does: it calls the master's side itself. */
clientConnectionSuite('RecordingConnection', (host) => ({
  dial(claim): ClientEnd {
    const connection = new WaitingConnection();
    const isRefused = host.refuseConnection(claim, LOCAL_CALLER) !== undefined;
    const handle = isRefused ? undefined : host.openConnection(claim, connection, LOCAL_CALLER);
    return endOf(connection, handle);
  },
  caller: LOCAL_CALLER,
  tells: { program: undefined, token: true, reason: true, leaving: true },
  settle,
  close: () => undefined,
}));

/** A pipe whose other end waits while it is not read. */
class WaitingConnection extends RecordingConnection {
  readonly #waiting: (() => void)[] = [];

  /** Sends now, or when it is read again. */
  whenRead(send: () => void): void {
    if (this.isReading) send();
    else this.#waiting.push(send);
  }

  override setReading(on: boolean): void {
    super.setReading(on);
    if (on) for (const send of this.#waiting.splice(0)) send();
  }
}

function endOf(connection: WaitingConnection, handle: ConnectionHandle | undefined): ClientEnd {
  const send = (text: string): void => {
    if (handle !== undefined) handleText(handle, text);
  };
  return {
    next: () => Promise.resolve(connection.sent.shift()!),
    ended: () => Promise.resolve(),
    sendTopicData: (bytes) => connection.whenRead(() => handle?.handleTopicData(bytes.slice())),
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
