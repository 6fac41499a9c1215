import type { RecordingEvent } from './recording-event.ts';

/** Names whose state an event tells: a later event with the same key replaces it. Undefined for markers and gaps. */
export function stateKey({ kind, value }: RecordingEvent): string | undefined {
  switch (kind) {
    case 'session':
    case 'client':
    case 'device':
      return `${kind} ${value.id}`;
    case 'clock':
      return `${kind} ${value.clientId}`;
    case 'marker':
    case 'gap':
      return undefined;
  }
}
