/** The source files that the example shows. */
export const SOURCE_FILES = [
  {
    name: 'Page',
    fileName: 'useObjectDetection.ts',
    load: async () => (await import('./useObjectDetection.ts?raw')).default,
  },
  {
    name: 'Session',
    fileName: 'seeing-session.ts',
    load: async () => (await import('../../devices/camera/seeing-session.ts?raw')).default,
  },
  {
    name: 'Sources',
    fileName: 'usePictureSource.ts',
    load: async () => (await import('../pictures/usePictureSource.ts?raw')).default,
  },
];
