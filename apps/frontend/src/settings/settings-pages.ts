import { ClipboardList, FileText, Gauge, Info, Monitor, Network, Server } from '@lucide/vue';
import type { Component } from 'vue';

/** A page of the settings. */
export interface SettingsPage {
  readonly title: string;
  readonly to: string;
  readonly icon: Component;
  /** Search words for the command palette. */
  readonly words: string;
  /** Only in a cluster of masters. */
  readonly isOfCluster?: boolean;
}

/** Pages of the settings, in the order of their navigation. */
export const SETTINGS_PAGES: readonly SettingsPage[] = [
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
  {
    title: 'Masters',
    to: '/settings/masters',
    icon: Network,
    words: 'cluster, NATS, other masters',
    isOfCluster: true,
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
