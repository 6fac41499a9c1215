import { Blocks, ClipboardList, ConciergeBell, Play } from '@lucide/vue';
import { SERVICES, type ServiceName } from '@ubii/proto';
import { computed, type ComputedRef } from 'vue';
import { useRouter, type RouteLocationRaw } from 'vue-router';
import { useConnection } from '../../connection/useConnection.ts';
import { EXAMPLES } from '../../examples/catalogue.ts';
import { callLocation } from '../../locations/call-location.ts';
import { clientLocation } from '../../locations/client-location.ts';
import { moduleLocation } from '../../locations/module-location.ts';
import { useModuleLibrary } from '../../modules/library/useModuleLibrary.ts';
import type { Command } from '../../page/command.ts';
import { useShell } from '../../page/shell.ts';
import { playerIdentity } from '../../players/player-identity.ts';
import { useSettingsPages } from '../../settings/useSettingsPages.ts';
import { isInternalTopic } from '../../topics/names/internal-topics.ts';
import { PAGES, SETTINGS_PAGE } from '../pages.ts';
import { useActionCommands } from './useActionCommands.ts';
import { useSessionCommands } from './useSessionCommands.ts';

/** Interval of requests for topics while the palette is open, milliseconds. */
const TOPICS_INTERVAL_MS = 1000;

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

  const pages = [...PAGES, SETTINGS_PAGE].map(({ title, to, icon, shortcut }): Command => ({
    id: `page ${to}`,
    kind: 'page',
    title,
    icon,
    shortcut,
    run: go(to),
  }));
  const studies: Command = {
    id: 'page /studies',
    kind: 'page',
    title: 'Studies',
    icon: ClipboardList,
    run: go('/studies'),
  };
  const settingsPages = useSettingsPages();
  const settings = computed(() =>
    settingsPages.value
      .filter(({ to }) => to !== SETTINGS_PAGE.to)
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
      letter: playerIdentity(id, name).letter,
      run: go(clientLocation(id)),
    })),
  );
  const streams = computed(() =>
    [...(topics.rates.value?.values() ?? [])]
      .filter(({ statistic }) => !isInternalTopic(statistic.topic))
      .map(({ statistic }): Command => ({
        id: `topic ${statistic.topic}`,
        kind: 'topic',
        title: statistic.topic,
        format: statistic.dataFormat,
        run: go(`/topics?topic=${encodeURIComponent(statistic.topic)}`),
      })),
  );

  return computed(() => [
    ...shell.pageCommands.value,
    ...pages,
    studies,
    ...settings.value,
    ...examples,
    ...actions.value,
    ...runs.value,
    ...modules.value,
    ...people.value,
    ...services,
    ...streams.value,
  ]);
}
