import { EXAMPLE_SESSIONS } from '@ubii/modules';
import { fromJson, toJson, type Init, type Session } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { GALLERY } from './gallery.ts';
import { gallerySession, inputClient, isSessionOf, withInputsOf } from './gallery-session.ts';

const ANN = '0f8fad5b-d9cb-469f-a165-70867728950e';
const BOB = '7c9e6679-7425-40de-944b-e07fc1f90ae7';
const SESSION = 'ubii.sessions.Session';

const entryOf = (id: string) => GALLERY.find((entry) => entry.id === id)!;
function sessionOf(id: string, clientId: string, changes: Init<Session> = {}): Session {
  const entry = entryOf(id);
  const spec = { ...gallerySession(entry, EXAMPLE_SESSIONS[entry.id], clientId), ...changes };
  return fromJson(SESSION, toJson(SESSION, spec));
}
const topicsOf = ({ ioMappings }: Session): string[] =>
  ioMappings.flatMap(({ inputMappings }) => inputMappings.flatMap(({ topic }) => topic || []));

describe('the gallery', () => {
  it('has twelve sessions, each once, with its name, a sentence and what it shows', () => {
    expect(new Set(GALLERY.map(({ id }) => id)).size).toBe(12);
    for (const { id, title, sentence, shows } of GALLERY) {
      expect(EXAMPLE_SESSIONS[id].name).toBe(title);
      expect(sentence).toMatch(/^[A-Z].*\.$/);
      expect(shows.length).toBeGreaterThan(0);
    }
  });

  it('asks for no input that its session does not take', () => {
    for (const { id, inputs } of GALLERY.filter(({ id }) => id !== 'many-pointers')) {
      const spec = fromJson(SESSION, toJson(SESSION, EXAMPLE_SESSIONS[id]));
      for (const { topic } of inputs) expect(topicsOf(spec), id).toContain(topic);
    }
  });
});

describe('the session of an example', () => {
  it.each(GALLERY)(
    'says what $id does, and names what to look at in its graph',
    ({ id, advice }) => {
      const { description, ioMappings } = sessionOf(id, ANN);
      expect(description.endsWith(` ${advice}`)).toBe(true);
      const names = ioMappings.flatMap(({ inputMappings, outputMappings }) => [
        ...inputMappings.map(({ topicMux }) => topicMux?.name),
        ...outputMappings.map(({ topic }) => topic?.split('/').at(-1)),
      ]);
      names.push(...EXAMPLE_SESSIONS[id].processingModules!.map(({ name }) => name ?? undefined));
      const quoted = [...advice.matchAll(/“([^”]+)”/g)].map(([, name]) => name);
      expect(quoted.length).toBeGreaterThan(0);
      for (const name of quoted) expect(names).toContain(name);
    },
  );

  it('takes the inputs of the client that starts it', () => {
    const session = sessionOf('click-counter', ANN);
    expect(session.name).toBe('Click counter');
    expect(topicsOf(session)).toEqual([`/${ANN}/web-page/is_pressed`, `/${ANN}/web-page/escape`]);
    expect(inputClient(entryOf('click-counter'), session)).toBe(ANN);
  });

  it('is handed to another client', () => {
    const entry = entryOf('pointer-speed');
    const session = sessionOf('pointer-speed', ANN);
    const handed = { ...session, ioMappings: withInputsOf(entry, session, BOB) };
    expect(inputClient(entry, handed)).toBe(BOB);
    expect(topicsOf(handed)).toEqual([`/${BOB}/web-example-mouse-pointer/mouse_client_position`]);
  });

  it('has no client when it needs nothing from a page', () => {
    expect(inputClient(entryOf('sine-wave'), sessionOf('sine-wave', ANN))).toBeUndefined();
  });

  it('is found again among others', () => {
    const own = sessionOf('sine-wave', ANN, { id: 'a' });
    const other = sessionOf('hysteresis', ANN, { id: 'c' });
    expect([other, own].filter((one) => isSessionOf(entryOf('sine-wave'), one))).toEqual([own]);
  });
});
