/** Pages of the navigation: what their titles begin with, and their paths. The last one is where one starts. */
export const NAVIGATION_PAGES = [
  ['Sessions', '/sessions'],
  ['Modules', '/modules'],
  ['Topics', '/topics'],
  ['Publish', '/publish'],
  ['Services', '/calls'],
  ['Clients', '/clients'],
  ['Performance', '/performance/round-trip'],
  ['Examples', '/examples'],
  ['Settings', '/settings'],
  ['Home', '/'],
] as const;
