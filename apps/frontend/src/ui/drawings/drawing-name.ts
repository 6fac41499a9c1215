/** What is drawn on an empty page. */
export type DrawingName =
  | 'plot'
  | 'timeline'
  | 'panels'
  | 'clients'
  | 'module'
  | 'bridge'
  | 'study';
