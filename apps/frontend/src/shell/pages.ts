import {
  Activity,
  Blocks,
  BookOpen,
  Cable,
  CircleDot,
  ClipboardList,
  ConciergeBell,
  Gamepad2,
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
}

/** Pages under a label of the navigation. */
export interface PageGroup {
  readonly title: string;
  readonly pages: readonly NavigationPage[];
}

export const HOME: NavigationPage = { title: 'Home', to: '/', icon: House, shortcut: 'G H' };

const SESSIONS: NavigationPage = {
  title: 'Sessions',
  to: '/sessions',
  icon: Workflow,
  shortcut: 'G S',
};

/** This browser as a device. On computers it belongs to the clients. */
export const DEVICES: NavigationPage = {
  title: 'Devices',
  to: '/devices',
  icon: Smartphone,
  shortcut: 'G D',
};

export const GROUPS: readonly PageGroup[] = [
  {
    title: 'Build',
    pages: [
      SESSIONS,
      { title: 'Modules', to: '/modules', icon: Blocks, shortcut: 'G M' },
      { title: 'Examples', to: '/examples', icon: Shapes, shortcut: 'G E' },
    ],
  },
  {
    title: 'Data',
    pages: [
      { title: 'Topics', to: '/topics', icon: ListTree, shortcut: 'G T' },
      { title: 'Panels', to: '/panels', icon: LayoutDashboard, shortcut: 'G P' },
      { title: 'Recordings', to: '/recordings', icon: CircleDot, shortcut: 'G R' },
    ],
  },
  {
    title: 'Room',
    pages: [
      {
        title: 'Clients',
        to: '/clients',
        icon: MonitorSmartphone,
        shortcut: 'G C',
        sibling: DEVICES.to,
      },
      { title: 'Party', to: '/party', icon: Gamepad2, shortcut: 'G Y' },
    ],
  },
];

/** Folded, below the groups. */
export const TOOLS: readonly NavigationPage[] = [
  { title: 'Publish', to: '/publish', icon: Send, shortcut: 'G B' },
  { title: 'Services', to: '/calls', icon: ConciergeBell, shortcut: 'G V' },
  { title: 'Bridges', to: '/bridges', icon: Cable, shortcut: 'G I' },
  { title: 'Performance', to: '/performance', icon: Activity, shortcut: 'G F' },
  { title: 'Studies', to: '/studies', icon: ClipboardList, shortcut: 'G U' },
];

/** At the foot of the navigation. */
export const FOOT: readonly NavigationPage[] = [
  { title: 'Learn', to: '/learn', icon: BookOpen, shortcut: 'G L' },
  { title: 'Settings', to: '/settings', icon: Settings, shortcut: 'G ,' },
];

/** In the bar of phones; all others are in the sheet of its last item. */
export const PHONE_PAGES: readonly NavigationPage[] = [HOME, DEVICES, SESSIONS];

export const PAGES: readonly NavigationPage[] = [
  HOME,
  ...GROUPS.flatMap(({ pages }) => pages),
  ...TOOLS,
  DEVICES,
  ...FOOT,
];

/** True when the path belongs to the page or to its sibling. */
export function isOn(path: string, { to, sibling }: NavigationPage): boolean {
  return isUnder(path, to) || (sibling !== undefined && isUnder(path, sibling));
}

/** True for the page itself and its subpages. */
export function isUnder(path: string, page: string): boolean {
  return page === '/' ? path === '/' : path === page || path.startsWith(`${page}/`);
}
