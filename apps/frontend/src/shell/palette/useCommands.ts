import { Blocks, ConciergeBell, Play, Send, Workflow } from '@lucide/vue';
import { SERVICES, type ServiceName } from '@ubii/proto';
import { computed, type ComputedRef } from 'vue';
import { useRouter, type RouteLocationRaw } from 'vue-router';
import { useConnection } from '../../connection/useConnection.ts';
import { EXAMPLES } from '../../examples/catalogue.ts';
import { GALLERY, type GalleryEntry } from '../../examples/gallery/gallery.ts';
import { useGallerySessions } from '../../examples/gallery/useGallerySessions.ts';
import { callLocation } from '../../locations/call-location.ts';
import { clientLocation } from '../../locations/client-location.ts';
import { moduleLocation } from '../../locations/module-location.ts';
import { topicPublishLocation } from '../../locations/topic-location.ts';
import { useModuleLibrary } from '../../modules/library/useModuleLibrary.ts';
import type { Command } from '../../page/command.ts';
import { useShell } from '../../page/shell.ts';
import { useSettingsPages } from '../../settings/useSettingsPages.ts';
import { isInternalTopic } from '../../topics/names/internal-topics.ts';
import { useFindPublisher } from '../../topics/names/useFindPublisher.ts';
import { useShortTopic } from '../../topics/names/useShortTopic.ts';
import { PAGES } from '../pages.ts';
import { useActionCommands } from './useActionCommands.ts';
import { useSessionCommands } from './useSessionCommands.ts';

/** Interval of requests for topics while the palette is open, milliseconds. */
const TOPICS_INTERVAL_MS = 1000;

const loadExampleSessions = () =>
  import('@ubii/modules').then(({ EXAMPLE_SESSIONS }) => ({
    spec: ({ id }: GalleryEntry) => EXAMPLE_SESSIONS[id],
  }));

/** All commands of the palette, updated while it is open. */
export function useCommands(): ComputedRef<Command[]> {
  const router = useRouter();
  const shell = useShell();
  const { clients, topics } = useConnection();
  const library = useModuleLibrary();
  const actions = useActionCommands();
  const runs = useSessionCommands();
  topics.watch(TOPICS_INTERVAL_MS);

  const go = (to: RouteLocationRaw) => () => void router.push(to);

  const pages = PAGES.map(({ title, to, icon, shortcut }): Command => ({
    id: `page ${to}`,
    kind: 'page',
    title,
    icon,
    shortcut,
    run: go(to),
  }));
  const settingsPages = useSettingsPages();
  const settings = computed(() =>
    settingsPages.value
      .filter(({ to }) => !PAGES.some((page) => page.to === to))
      .map(({ title, to, icon, words }): Command => ({
        id: `page ${to}`,
        kind: 'page',
        title: `Settings, ${title}`,
        detail: words,
        icon,
        run: go(to),
      })),
  );
  const examples = EXAMPLES.map(({ id, title, sentence, path }): Command => ({
    id: `example ${id}`,
    kind: 'example',
    title,
    detail: sentence,
    icon: Play,
    run: go(path),
  }));
  const gallery = useGallerySessions(loadExampleSessions);
  async function startExample(entry: GalleryEntry): Promise<void> {
    await gallery.start(entry);
    // There one can try again.
    if (gallery.of(entry).trouble.value !== undefined) await router.push('/examples');
  }
  const startable = GALLERY.map((entry): Command => ({
    id: `start ${entry.id}`,
    kind: 'example',
    title: entry.title,
    detail: `Start and open: ${entry.sentence}`,
    icon: Workflow,
    run: () => void startExample(entry),
  }));
  const services = (Object.keys(SERVICES) as ServiceName[]).map((name): Command => ({
    id: `service ${name}`,
    kind: 'service',
    title: SERVICES[name].topic.replace('/services/', ''),
    detail: SERVICES[name].description,
    icon: ConciergeBell,
    run: go(callLocation(name)),
  }));

  const modules = computed(() =>
    (library.entries.value ?? []).map(({ module: { name, description } }): Command => ({
      id: `module ${name}`,
      kind: 'module',
      title: name,
      detail: description,
      icon: Blocks,
      run: go(moduleLocation(name)),
    })),
  );
  const people = computed(() =>
    (clients.list.value ?? []).map(({ id, name, description }): Command => ({
      id: `client ${id}`,
      kind: 'client',
      title: name || id,
      detail: description,
      clientId: id,
      run: go(clientLocation(id)),
    })),
  );
  const shortTopic = useShortTopic();
  const findPublisher = useFindPublisher();
  /** Topics of a client are found by its name, not by its id. */
  const topicWords = (topic: string, publisherId: string) => {
    const { text, owner } = shortTopic(topic);
    return { title: text, detail: owner ?? findPublisher(publisherId)?.name ?? '' };
  };
  const streams = computed(() =>
    [...(topics.rates.value?.values() ?? [])]
      .filter(({ statistic }) => !isInternalTopic(statistic.topic))
      .flatMap(({ statistic }): Command[] => {
        const { topic, publisherId, dataFormat: format } = statistic;
        const words = topicWords(topic, publisherId);
        return [
          {
            id: `topic ${topic}`,
            kind: 'topic',
            ...words,
            format,
            run: go(`/topics?topic=${encodeURIComponent(topic)}`),
          },
          {
            id: `publish ${topic}`,
            kind: 'publish',
            title: `Publish to ${words.title}`,
            detail: words.detail,
            icon: Send,
            run: go(topicPublishLocation(topic)),
          },
        ];
      }),
  );

  return computed(() => [
    ...shell.pageCommands.value,
    ...pages,
    ...settings.value,
    ...examples,
    ...startable,
    ...actions.value,
    ...runs.value,
    ...modules.value,
    ...people.value,
    ...services,
    ...streams.value,
  ]);
}
