/** The source files that the example shows. */
export const SOURCE_FILES = [
  { name: 'Page', load: async () => (await import('./useObjectDetection.ts?raw')).default },
  {
    name: 'Session',
    load: async () => (await import('../../devices/camera/seeing-session.ts?raw')).default,
  },
  {
    name: 'Sources',
    load: async () => (await import('../pictures/use-picture-source.ts?raw')).default,
  },
];
