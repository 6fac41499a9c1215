import { shallowRef, type ComputedRef, type ShallowRef } from 'vue';
import { fromJson, toJson, type Session } from '@ubii/proto';
import { randomUuid } from '../../../connection/random-uuid.ts';
import { useConnection } from '../../../connection/useConnection.ts';
import { completeExample } from '../../../sessions/examples/complete-example.ts';
import { knownModules } from '../../../sessions/file/known-modules.ts';
import { completeSession } from '../../model/complete-session.ts';
import { drawnSize } from '../../nodes/drawn-size.ts';
import { freeName } from '../../../sessions/text/session-spec.ts';
import { writtenTopics } from '../../../sessions/words/shared-topics.ts';
import { addSession } from '../../model/add-session.ts';
import { topicsOf } from '../../model/commands/free-topic.ts';
import type { Point } from '../../model/graph.ts';
import type { GraphEditor } from '../../editing/graph-editor.ts';
import type { Template } from './templates.ts';
import { useExamplePointer } from './useExamplePointer.ts';
import { withPointer } from './with-pointer.ts';

/** Template with a preview. */
export interface SeenTemplate {
  readonly template: Template;
  readonly seen: Session;
}

export interface Templates {
  /** Templates whose modules are available; empty until loaded. */
  readonly list: Readonly<ShallowRef<readonly SeenTemplate[]>>;
  /** Topic of a live pointer, in this browser or on a phone; undefined while there is none. */
  readonly pointer: ComputedRef<string | undefined>;
  load(): Promise<void>;
  /** Adds a template to the graph, as one undo step. @returns the reason when it failed */
  use(template: Template, position: Point): string | undefined;
}

const SESSION = 'ubii.sessions.Session';
/** True for the default name of a new session. */
const isDefaultName = (name: string): boolean => /^Session(?: \d+)?$/.test(name);

export function useTemplates(editor: GraphEditor): Templates {
  const { client, sessions } = useConnection();
  const pointer = useExamplePointer();
  const list = shallowRef<readonly SeenTemplate[]>([]);

  async function load(): Promise<void> {
    // Loaded on demand: the library is large, and only this list needs it.
    const [{ moduleLibrary }, { TEMPLATES }, known] = await Promise.all([
      import('@ubii/modules'),
      import('./templates.ts'),
      knownModules(client),
    ]);
    const library = moduleLibrary();
    const names = new Set([...(known ?? library), ...library].map(({ name }) => name));
    list.value = TEMPLATES.filter(({ session }) =>
      (session.processingModules ?? []).every(({ name }) => names.has(name ?? '')),
    ).map((template) => {
      const whole = completeSession(fromJson(SESSION, toJson(SESSION, template.session)), library);
      return { template, seen: completeExample(whole, library) };
    });
  }

  return {
    list,
    pointer: pointer.live,
    load,
    use(template, position) {
      const seen = list.value.find((one) => one.template === template)?.seen;
      if (seen === undefined) return 'The example no longer exists.';
      const topic = pointer.take(template);
      const { graph } = editor;
      const isEmpty = graph.value.nodes.size === 0;
      const isUnnamed = isEmpty && isDefaultName(graph.value.details.name);
      const others = (sessions.list.value ?? []).filter(({ id }) => id !== editor.session.value.id);
      const name = freeName(template.title, new Set(others.map((one) => one.name)));
      const added = addSession(graph.value, withPointer(seen, template.pointerTopic, topic), {
        uuid: randomUuid,
        position,
        sizeOf: drawnSize,
        label: `Add ${template.title}`,
        ...(isUnnamed && { as: { name, description: seen.description } }),
      });
      if (added.kind === 'broken') return added.reason;
      // Two sessions from one example must not write to each other.
      const before = topicsOf(graph.value);
      const written = others.flatMap((one) => [...writtenTopics(one)]);
      const topics = written.filter((one) => !before.has(one));
      const ownTopics = { kind: 'ownTopics', topics } as const;
      const commands = [added.command, ownTopics];
      editor.apply({ kind: 'all', label: `Add ${template.title}`, commands });
      if (!isEmpty) editor.select(added.ids);
      return undefined;
    },
  };
}
