import {
  Activity,
  Blocks,
  BookOpen,
  Cable,
  CircleDot,
  ConciergeBell,
  House,
  LayoutDashboard,
  ListTree,
  MonitorSmartphone,
  Send,
  Settings,
  Shapes,
  Smartphone,
  Workflow,
} from '@lucide/vue';
import type { Component } from 'vue';

/** Page of the navigation. */
export interface NavigationPage {
  readonly title: string;
  readonly to: string;
  readonly icon: Component;
  readonly shortcut: string;
  /** Path of another page that belongs to it. */
  readonly sibling?: string;
  /** On phones it is in the sheet of the last item. */
  readonly isBehindMore?: boolean;
}

export const PAGES: readonly NavigationPage[] = [
  { title: 'Home', to: '/', icon: House, shortcut: 'G H' },
  { title: 'Sessions', to: '/sessions', icon: Workflow, shortcut: 'G N' },
  { title: 'Modules', to: '/modules', icon: Blocks, shortcut: 'G M', isBehindMore: true },
  { title: 'Topics', to: '/topics', icon: ListTree, shortcut: 'G T' },
  { title: 'Publish', to: '/publish', icon: Send, shortcut: 'G B', isBehindMore: true },
  { title: 'Services', to: '/calls', icon: ConciergeBell, shortcut: 'G V', isBehindMore: true },
  {
    title: 'Clients',
    to: '/clients',
    icon: MonitorSmartphone,
    shortcut: 'G C',
    isBehindMore: true,
  },
  { title: 'Bridges', to: '/bridges', icon: Cable, shortcut: 'G I', isBehindMore: true },
  {
    title: 'Recordings',
    to: '/recordings',
    sibling: '/studies',
    icon: CircleDot,
    shortcut: 'G O',
    isBehindMore: true,
  },
  {
    title: 'Panels',
    to: '/panels',
    icon: LayoutDashboard,
    shortcut: 'G L',
    isBehindMore: true,
  },
  {
    title: 'Performance',
    to: '/performance',
    icon: Activity,
    shortcut: 'G P',
    isBehindMore: true,
  },
  { title: 'Devices', to: '/devices', icon: Smartphone, shortcut: 'G D' },
  { title: 'Examples', to: '/examples', icon: Shapes, shortcut: 'G E', isBehindMore: true },
  { title: 'Learn', to: '/learn', icon: BookOpen, shortcut: 'G R', isBehindMore: true },
];

export const SETTINGS_PAGE: NavigationPage = {
  title: 'Settings',
  to: '/settings',
  icon: Settings,
  shortcut: 'G S',
};

/** True when the path belongs to the page or to its sibling. */
export function isOn(path: string, { to, sibling }: NavigationPage): boolean {
  return isUnder(path, to) || (sibling !== undefined && isUnder(path, sibling));
}

/** True for the page itself and its subpages. */
export function isUnder(path: string, page: string): boolean {
  return page === '/' ? path === '/' : path === page || path.startsWith(`${page}/`);
}
