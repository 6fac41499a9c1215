/** Result of probing the WebSocket. */
export type ChannelProbe =
  | {
      readonly isOpen: true;
      /** Shortest round trip, milliseconds. */
      readonly roundTripMs: number;
      /** Offset of the master's clock relative to this device's, milliseconds. */
      readonly offsetMs: number;
      /** Bound on the error of the offset, milliseconds. */
      readonly errorMs: number;
    }
  | { readonly isOpen: false; readonly reason: 'refused' | 'silent' };

const QUESTIONS = 5;
const TIMEOUT_MS = 6000;

/**
 * Opens a WebSocket to the master and requests its time, several times in sequence. [AC-29] The shortest round trip
 * gives the best measurement.
 */
export function probeChannel(origin: string, createSocket = openSocket): Promise<ChannelProbe> {
  return new Promise((resolve) => {
    const socket = createSocket(`${origin.replace(/^http/, 'ws')}/preflight`);
    let best: { roundTripMs: number; offsetMs: number } | undefined;
    let asked = 0;
    let sentMs = 0;

    const finish = (failure: 'refused' | 'silent'): void => {
      clearTimeout(timer);
      socket.onopen = socket.onmessage = socket.onclose = socket.onerror = null;
      socket.close();
      resolve(
        best === undefined
          ? { isOpen: false, reason: failure }
          : { isOpen: true, ...best, errorMs: best.roundTripMs / 2 },
      );
    };
    const timer = setTimeout(() => finish('silent'), TIMEOUT_MS);
    const ask = (): void => {
      asked += 1;
      sentMs = performance.now();
      socket.send(String(asked));
    };

    socket.onopen = ask;
    socket.onmessage = ({ data }) => {
      const receivedMs = performance.now();
      const [number, masterMs] = String(data).split(' ').map(Number);
      if (number !== asked || masterMs === undefined || Number.isNaN(masterMs)) return;
      const roundTripMs = receivedMs - sentMs;
      if (best === undefined || roundTripMs < best.roundTripMs) {
        const middleMs = performance.timeOrigin + (sentMs + receivedMs) / 2;
        // `performance.now()` does not follow changes of the system clock since the page was opened: add them.
        const setMs = Date.now() - (performance.timeOrigin + receivedMs);
        best = { roundTripMs, offsetMs: masterMs - middleMs - (Math.abs(setMs) > 50 ? setMs : 0) };
      }
      if (asked < QUESTIONS) ask();
      else finish('silent');
    };
    socket.onclose = socket.onerror = () => finish('refused');
  });
}

function openSocket(url: string): WebSocket {
  return new WebSocket(url);
}
