import { ClipboardList, FileText, Gauge, Info, Monitor, Server } from '@lucide/vue';
import type { Component } from 'vue';

/** Pages of the settings, in the order of their navigation. */
export const SETTINGS_PAGES: readonly {
  readonly title: string;
  readonly to: string;
  readonly icon: Component;
  /** Search words for the command palette. */
  readonly words: string;
}[] = [
  {
    title: 'This browser',
    to: '/settings',
    icon: Monitor,
    words: 'name, theme, keys, modules, connection',
  },
  {
    title: 'Master',
    to: '/settings/master',
    icon: Server,
    words: 'version, uptime, addresses, start options, checks, diagnostics',
  },
  { title: 'Limits', to: '/settings/limits', icon: Gauge, words: 'limits and current use' },
  { title: 'Log', to: '/settings/log', icon: FileText, words: 'messages of the master' },
  {
    title: 'Audit log',
    to: '/settings/audit',
    icon: ClipboardList,
    words: 'changes made by clients',
  },
  {
    title: 'Licences',
    to: '/settings/licences',
    icon: Info,
    words: 'about, versions, third-party packages',
  },
];
