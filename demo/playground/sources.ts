// Where does a `src` lead? To this site, which may be loaded at once; to another host, which needs a click; or
// somewhere that a link has no business with (javascript:, data:, blob:, file:).

export type SourceKind = 'own' | 'refused' | { readonly host: string };

/** @param base the address that relative sources refer to. */
export function sourceKind(source: string, base: string): SourceKind {
  if (!URL.canParse(source, base)) return 'refused';
  const { protocol, origin } = new URL(source, base);
  // Checked first: the origin of `blob:https://this.site/…` is this site's.
  if (protocol !== 'http:' && protocol !== 'https:') return 'refused';
  return origin === new URL(base).origin ? 'own' : { host: origin };
}
