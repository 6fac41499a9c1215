import type { Clock } from '@ubii/client-web/node';
import type { MemoryConnection, MemoryMaster, MemoryPeer } from '@ubii/client-web/testing';

/** Delays of the next packet in the two directions of a socket, milliseconds. */
export interface Line {
  toMasterMs(): number;
  toPhoneMs(): number;
}

/** A master behind a line that takes its time. The order stays, as TCP keeps it; services take none. */
export function behindLine(master: MemoryMaster, clock: Clock, line: Line): MemoryMaster {
  const way = (takesMs: () => number): ((deliver: () => void) => void) => {
    let lastMs = -Infinity;
    return (deliver) => {
      const nowMs = clock.monotonicMs();
      lastMs = Math.max(lastMs, nowMs + takesMs());
      if (lastMs > nowMs) clock.after(lastMs - nowMs, deliver);
      else deliver();
    };
  };
  return {
    handleServiceRequest: (request, bearer) => master.handleServiceRequest(request, bearer),
    openConnection(query, peer) {
      const up = way(() => line.toMasterMs());
      const down = way(() => line.toPhoneMs());
      const connection = master.openConnection(query, slowPeer(peer, down));
      return connection && slowConnection(connection, up);
    },
  };
}

function slowPeer(peer: MemoryPeer, down: (deliver: () => void) => void): MemoryPeer {
  return {
    sendBinary(bytes) {
      const copy = bytes.slice();
      down(() => peer.sendBinary(copy));
    },
    sendText: (text) => down(() => peer.sendText(text)),
    close: (code, reason) => down(() => peer.close(code, reason)),
    get queuedBytes() {
      return peer.queuedBytes;
    },
  };
}

function slowConnection(
  connection: MemoryConnection,
  up: (deliver: () => void) => void,
): MemoryConnection {
  return {
    handleBinary: (bytes) => up(() => connection.handleBinary(bytes)),
    handleText: (text) => up(() => connection.handleText(text)),
    handleClose: (code) => up(() => connection.handleClose(code)),
  };
}

/** A clock that was set wrong; its timers go right. @param aheadMs negative: behind */
export function clockAhead(clock: Clock, aheadMs: number): Clock {
  return {
    nowMs: () => clock.nowMs() + aheadMs,
    monotonicMs: () => clock.monotonicMs(),
    after: (delayMs, fn) => clock.after(delayMs, fn),
    every: (intervalMs, fn) => clock.every(intervalMs, fn),
    atEndOfTurn: (fn) => clock.atEndOfTurn(fn),
  };
}
