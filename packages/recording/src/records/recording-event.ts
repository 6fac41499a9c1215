/** A moment that a user or a module marked. The event with the highest sequence of an id is the valid one. */
export interface Marker {
  readonly id: string;
  /** The marked moment, milliseconds since the Unix epoch. */
  readonly timeMs: number;
  readonly text: string;
  /** Name of the author. */
  readonly author: string;
  /** Client id of the author; empty for the master. */
  readonly authorId: string;
  /** What made it, such as `key`, `button`, `module` or `service`. */
  readonly kind: string;
  /** The marker was deleted. @default false */
  readonly isRemoved?: boolean;
}

/** The clock of a client beside that of the master. */
export interface ClientClock {
  readonly clientId: string;
  /** Client's time minus master's time, milliseconds. */
  readonly offsetMs: number;
  /** Largest error of `offsetMs`, milliseconds. */
  readonly errorMs: number;
  /** Change of the offset, parts per million. */
  readonly driftPpm: number;
}

/** A session from this moment on. */
export interface RecordedSession {
  readonly id: string;
  readonly name: string;
  /** Such as `running`, `paused`, `stopped`. */
  readonly state: string;
  /** The session with the code of its modules, as JSON. */
  readonly session: string;
}

/** A client from this moment on. */
export interface RecordedClient {
  readonly id: string;
  readonly name: string;
  readonly tags: readonly string[];
  /** Such as `active`, `inactive`, `unavailable`. */
  readonly state: string;
}

/** A device from this moment on. */
export interface RecordedDevice {
  readonly id: string;
  readonly clientId: string;
  readonly name: string;
  readonly tags: readonly string[];
  /** `registered`, or `deregistered` from this moment on. */
  readonly state: string;
  readonly components: readonly RecordedComponent[];
}

/** A component of a device: what it publishes or takes. */
export interface RecordedComponent {
  readonly id: string;
  readonly name: string;
  readonly topic: string;
  /** As the client spelled it, such as `vector2` or `ubii.dataStructure.Vector2`. */
  readonly format: string;
  /** `publisher` or `subscriber`. */
  readonly direction: string;
  readonly tags: readonly string[];
}

/** Records that are missing. */
export interface Gap {
  /** @default all topics */
  readonly topic?: string;
  /** Milliseconds since the Unix epoch. */
  readonly fromMs: number;
  readonly untilMs: number;
  /** How many records are missing. */
  readonly records: number;
  readonly reason: string;
}

interface EventValues {
  marker: Marker;
  clock: ClientClock;
  session: RecordedSession;
  client: RecordedClient;
  device: RecordedDevice;
  gap: Gap;
}

/** Kinds of events beside records. */
export type EventKind = keyof EventValues;

/** The value of an event. */
export type EventValue<K extends EventKind = EventKind> = EventValues[K];

/** What else happened: one JSON message in a recording. */
export type RecordingEvent<K extends EventKind = EventKind> = K extends EventKind
  ? {
      readonly kind: K;
      /** When it applies: the marked moment of a marker. Nanoseconds since the Unix epoch. */
      readonly timeNs: bigint;
      readonly value: EventValues[K];
    }
  : never;

/** Topics of the JSON channels. */
export const EVENT_TOPICS: Readonly<Record<EventKind, string>> = {
  marker: '/recording/markers',
  clock: '/recording/clocks',
  session: '/recording/sessions',
  client: '/recording/clients',
  device: '/recording/devices',
  gap: '/recording/gaps',
};

/** Key of the state that an event sets: a later event with the same key replaces it. Undefined for markers and gaps. */
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
