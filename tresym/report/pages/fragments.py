from tresym.report.pages.derivation import fragment


def written(rows, style):
    return "\n".join(map(fragment, rows))
