import { fromJson, messageDescriptor, toJson } from '@ubii/proto';
import type { RecordedComponent, RecordingEvent } from '../records/recording-event.ts';
import type { PersonalRules } from './personal-rules.ts';
import { treatMessage, type Fields, type MessageTreatment } from './treat-message.ts';

/** Words of the master for states, directions and kinds of markers: readers know them. Others may be texts of a person. */
const WORDS = new Set([
  'active',
  'inactive',
  'unavailable',
  'registered',
  'deregistered',
  'publisher',
  'subscriber',
  'created',
  'running',
  'paused',
  'stopped',
  'key',
  'button',
  'module',
  'service',
  'topic',
]);
const SESSION = messageDescriptor('ubii.sessions.Session');

/** What becomes of events. */
export interface EventTreatment extends MessageTreatment {
  topic(topic: string): string | undefined;
  /** Added to all absolute times, nanoseconds. */
  readonly shiftNs: bigint;
}

/** Replaces personal data in an event; undefined when it is dropped. */
export function treatEvent(
  event: RecordingEvent,
  rules: PersonalRules,
  treatment: EventTreatment,
): RecordingEvent | undefined {
  const { text, clientId, name, timeMs } = treatment;
  const word = wordTreatment(treatment);
  const timeNs = event.timeNs + treatment.shiftNs;
  switch (event.kind) {
    case 'client': {
      const { id, tags, state } = event.value;
      const value = {
        id: clientId(id),
        name: name(event.value.name, 'client'),
        tags: tags.map(text),
        state: word(state),
      };
      return { kind: 'client', timeNs, value };
    }
    case 'device': {
      const { id, tags, state, components } = event.value;
      const value = {
        id: text(id),
        clientId: clientId(event.value.clientId),
        name: name(event.value.name, 'device'),
        tags: tags.map(text),
        state: word(state),
        components: components.flatMap((component) => treatComponent(component, treatment)),
      };
      return { kind: 'device', timeNs, value };
    }
    case 'clock': {
      const { offsetMs, errorMs, driftPpm } = event.value;
      const value = { clientId: clientId(event.value.clientId), offsetMs, errorMs, driftPpm };
      return { kind: 'clock', timeNs, value };
    }
    case 'marker': {
      const { value } = event;
      return {
        kind: 'marker',
        timeNs,
        value: {
          id: text(value.id),
          timeMs: timeMs(value.timeMs),
          text: rules.markerTexts === 'keep' ? text(value.text) : '',
          author: name(value.author, 'client'),
          authorId: clientId(value.authorId),
          kind: word(value.kind),
          ...(value.isRemoved === true && { isRemoved: true }),
        },
      };
    }
    case 'gap': {
      const { topic, fromMs, untilMs, records, reason } = event.value;
      const shared = topic === undefined ? undefined : treatment.topic(topic);
      if (topic !== undefined && shared === undefined) return undefined;
      const span = { fromMs: timeMs(fromMs), untilMs: timeMs(untilMs) };
      const value = { ...span, records, reason: text(reason) };
      return {
        kind: 'gap',
        timeNs,
        value: shared === undefined ? value : { topic: shared, ...value },
      };
    }
    case 'session': {
      const { id, state, session } = event.value;
      const value = {
        id: text(id),
        name: text(event.value.name),
        state: word(state),
        session: treatSession(session, treatment),
      };
      return { kind: 'session', timeNs, value };
    }
  }
}

/** Empty when the topic of the component is dropped. */
function treatComponent(component: RecordedComponent, treatment: EventTreatment) {
  const { id, name, format, tags } = component;
  const { text } = treatment;
  const topic = treatment.topic(component.topic);
  if (topic === undefined) return [];
  const direction = wordTreatment(treatment)(component.direction);
  const texts = { id: text(id), name: text(name), format: text(format), tags: tags.map(text) };
  return [{ ...texts, topic, direction }];
}

function wordTreatment({ text }: MessageTreatment): (word: string) => string {
  return (word) => (WORDS.has(word) ? word : text(word));
}

/** The session as its schema knows it, with its code; `{}` when it cannot be read. */
function treatSession(json: string, treatment: MessageTreatment): string {
  try {
    const session = fromJson('ubii.sessions.Session', JSON.parse(json));
    treatMessage(SESSION, session as unknown as Fields, treatment);
    return JSON.stringify(toJson('ubii.sessions.Session', session));
  } catch {
    return '{}';
  }
}
