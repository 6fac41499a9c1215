import {
  Activity,
  Blocks,
  House,
  ListTree,
  Settings,
  Shapes,
  MonitorSmartphone,
  Workflow,
} from '@lucide/vue';
import type { Component } from 'vue';

/** A page of the navigation. Only pages that exist stand here. */
export interface NavigationPage {
  readonly title: string;
  readonly to: string;
  readonly icon: Component;
  readonly shortcut: string;
  /** On phones it stands in the menu of the last item. */
  readonly isBehindMore?: boolean;
}

export const PAGES: readonly NavigationPage[] = [
  { title: 'Home', to: '/', icon: House, shortcut: 'G H' },
  { title: 'Sessions', to: '/sessions', icon: Workflow, shortcut: 'G N' },
  { title: 'Modules', to: '/modules', icon: Blocks, shortcut: 'G M', isBehindMore: true },
  { title: 'Topics', to: '/topics', icon: ListTree, shortcut: 'G T' },
  {
    title: 'Clients',
    to: '/clients',
    icon: MonitorSmartphone,
    shortcut: 'G C',
    isBehindMore: true,
  },
  {
    title: 'Performance',
    to: '/performance',
    icon: Activity,
    shortcut: 'G P',
    isBehindMore: true,
  },
  { title: 'Examples', to: '/examples', icon: Shapes, shortcut: 'G E' },
];

export const SETTINGS_PAGE: NavigationPage = {
  title: 'Settings',
  to: '/settings',
  icon: Settings,
  shortcut: 'G S',
};

/** True on the page itself and on the pages below it. */
export function isUnder(path: string, page: string): boolean {
  return page === '/' ? path === '/' : path === page || path.startsWith(`${page}/`);
}
